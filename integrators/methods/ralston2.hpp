#pragma once
#include "integrators/explicit_runge_kutta.hpp"
#include "integrators/order_conditions.hpp"

namespace odemark {

inline constexpr ExplicitRungeKutta<2> ralston2{
    .id = "ralston2",
    .source = "A. Ralston, Math. Comp. 16 (1962) 431-437",
    .advice = "least error bound of all two-stage methods; heun where monotonicity matters",
    .order = 2,
    .a = {{{}, {2.0L / 3}}},
    .b = {1.0L / 4, 3.0L / 4},
};
static_assert(orders_hold(ralston2));

}  // namespace odemark
