#pragma once
#include "integrators/rosenbrock.hpp"
#include "integrators/rosenbrock_order.hpp"

namespace odemark {

namespace detail {
inline constexpr Coefficient ros2_small_gamma_gamma =
    0.292893218813452475599155637895150960715L;  // 1 - 1/sqrt(2)
}

inline constexpr Rosenbrock<2> ros2_small_gamma{
    .id = "ros2_small_gamma",
    .source =
        "J. G. Verwer, E. J. Spee, J. G. Blom, W. Hundsdorfer, SIAM J. Sci. Comput. 20 (1999) 1456-1480, "
        "ROS2 with gamma = "
        "1 - 1/sqrt(2); estimate against the linearly implicit Euler step",
    .advice = "the same with a small error constant: the better of the two where sign is not at stake",
    .order = 2,
    .embedded_order = 1,
    .w_method = true,
    .alpha = {{{}, {1}}},
    .gamma = {{{detail::ros2_small_gamma_gamma},
               {-2 * detail::ros2_small_gamma_gamma, detail::ros2_small_gamma_gamma}}},
    .b = {1.0L / 2, 1.0L / 2},
    .b_embedded = {1},
};
static_assert(orders_hold(ros2_small_gamma));

}  // namespace odemark
