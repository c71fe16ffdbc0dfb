#pragma once
#include "integrators/diagonally_implicit_runge_kutta.hpp"
#include "integrators/order_conditions.hpp"

namespace odemark {

namespace detail {
// the middle root of x^3 - 3 x^2 + 3 x / 2 - 1 / 6
inline constexpr Coefficient alexander_gamma = 0.435866521508458999416019451193556842529L;
inline constexpr Coefficient alexander_b1 =
    -(6 * alexander_gamma * alexander_gamma - 16 * alexander_gamma + 1) / 4;
inline constexpr Coefficient alexander_b2 =
    (6 * alexander_gamma * alexander_gamma - 20 * alexander_gamma + 5) / 4;
}  // namespace detail

inline constexpr DiagonallyImplicitRungeKutta<3> sdirk3_alexander{
    .id = "sdirk3_alexander",
    .source = "R. Alexander, SIAM J. Numer. Anal. 14 (1977) 1006-1021, theorem 5",
    .order = 3,
    .a = {{{detail::alexander_gamma},
           {(1 - detail::alexander_gamma) / 2, detail::alexander_gamma},
           {detail::alexander_b1, detail::alexander_b2, detail::alexander_gamma}}},
    .b = {detail::alexander_b1, detail::alexander_b2, detail::alexander_gamma},
    .advice = "fixed steps over strong damping at order 3, L-stable and stiffly accurate; no error control",
};
static_assert(orders_hold(sdirk3_alexander));

}  // namespace odemark
