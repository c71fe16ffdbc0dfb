#pragma once
#include "integrators/diagonally_implicit_runge_kutta.hpp"
#include "integrators/order_conditions.hpp"

namespace odemark {

inline constexpr DiagonallyImplicitRungeKutta<1> implicit_euler{
    .id = "implicit_euler",
    .source = "E. Hairer, G. Wanner, Solving ODEs II, IV.3, eq. 3.2",
    .order = 1,
    .a = {{{1}}},
    .b = {1},
    .advice = "the last resort for any stiffness: stable and damping at every step, first order",
};
static_assert(orders_hold(implicit_euler));

}  // namespace odemark
