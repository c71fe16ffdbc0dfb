#pragma once
#include "integrators/diagonally_implicit_runge_kutta.hpp"
#include "integrators/order_conditions.hpp"

namespace odemark {

namespace detail {
inline constexpr Coefficient tr_bdf2_sqrt2 = 1.41421356237309504880168872420969808L;
}  // namespace detail

inline constexpr DiagonallyImplicitRungeKutta<3> tr_bdf2{
    .id = "tr_bdf2",
    .source =
        "R. E. Bank et al., IEEE Trans. Electron Devices 32 (1985) 1992-2007; as a pair: M. E. Hosea, L. F. "
        "Shampine, Appl. Numer. Math. 20 (1996) 21-37",
    .order = 2,
    .embedded_order = 3,
    .propagates_lower = true,
    .a = {{{},
           {1 - detail::tr_bdf2_sqrt2 / 2, 1 - detail::tr_bdf2_sqrt2 / 2},
           {detail::tr_bdf2_sqrt2 / 4, detail::tr_bdf2_sqrt2 / 4, 1 - detail::tr_bdf2_sqrt2 / 2}}},
    .b = {detail::tr_bdf2_sqrt2 / 4, detail::tr_bdf2_sqrt2 / 4, 1 - detail::tr_bdf2_sqrt2 / 2},
    .b_embedded = {(4 - detail::tr_bdf2_sqrt2) / 12, (4 + 3 * detail::tr_bdf2_sqrt2) / 12,
                   (2 - detail::tr_bdf2_sqrt2) / 6},
    .filter_estimate = true,
    .advice =
        "stiff circuits and springs at 1e-2 to 1e-3, L-stable; cheap and robust, not for tight tolerances",
};
static_assert(orders_hold(tr_bdf2));

}  // namespace odemark
