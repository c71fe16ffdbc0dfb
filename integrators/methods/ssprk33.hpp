#pragma once
#include "integrators/explicit_runge_kutta.hpp"
#include "integrators/order_conditions.hpp"

namespace odemark {

inline constexpr ExplicitRungeKutta<3> ssprk33{
    .id = "ssprk33",
    .source = "C.-W. Shu, S. Osher, J. Comput. Phys. 77 (1988) 439-471",
    .advice = "for hyperbolic problems that Euler keeps monotone; not the most accurate order 3 elsewhere",
    .order = 3,
    .a = {{{}, {1}, {1.0L / 4, 1.0L / 4}}},
    .b = {1.0L / 6, 1.0L / 6, 2.0L / 3},
};
static_assert(orders_hold(ssprk33));

}  // namespace odemark
