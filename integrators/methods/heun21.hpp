#pragma once
#include "integrators/explicit_runge_kutta.hpp"
#include "integrators/order_conditions.hpp"

namespace odemark {

inline constexpr ExplicitRungeKutta<2> heun21{
    .id = "heun21",
    .source = "K. Heun, Z. Math. Phys. 45 (1900) 23-38, with Euler as the estimate",
    .advice = "the simplest pair: crude tolerances and non-smooth right-hand sides; two evaluations",
    .order = 2,
    .embedded_order = 1,
    .a = {{{}, {1}}},
    .b = {1.0L / 2, 1.0L / 2},
    .b_embedded = {1, 0},
};
static_assert(orders_hold(heun21));

}  // namespace odemark
