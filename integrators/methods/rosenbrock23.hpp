#pragma once
#include "integrators/rosenbrock.hpp"
#include "integrators/rosenbrock_order.hpp"

namespace odemark {

namespace detail {
inline constexpr Coefficient rosenbrock23_d = 0.292893218813452475599155637895150960715L;   // 1/(2 + sqrt(2))
inline constexpr Coefficient rosenbrock23_e32 = 7.41421356237309504880168872420969807857L;  // 6 + sqrt(2)
}  // namespace detail

inline constexpr Rosenbrock<3> rosenbrock23{
    .id = "rosenbrock23",
    .source = "L. F. Shampine, M. W. Reichelt, SIAM J. Sci. Comput. 18 (1997) 1-22, section 4.1 (ode23s)",
    .advice = "stiff problems at 1e-2 to 1e-3, also with a rough Jacobian; for more digits rodas4",
    .order = 2,
    .embedded_order = 3,
    .propagates_lower = true,
    .w_method = true,
    .alpha = {{{}, {1.0L / 2}, {0, 1}}},
    .gamma = {{{detail::rosenbrock23_d},
               {-detail::rosenbrock23_d, detail::rosenbrock23_d},
               {detail::rosenbrock23_d * (detail::rosenbrock23_e32 - 2),
                -detail::rosenbrock23_d* detail::rosenbrock23_e32, detail::rosenbrock23_d}}},
    .b = {0, 1},
    .b_embedded = {1.0L / 6, 2.0L / 3, 1.0L / 6},
};
static_assert(orders_hold(rosenbrock23));

}  // namespace odemark
