#pragma once
#include "integrators/explicit_runge_kutta.hpp"
#include "integrators/order_conditions.hpp"

namespace odemark {

inline constexpr ExplicitRungeKutta<3> heun3{
    .id = "heun3",
    .source = "K. Heun, Z. Math. Phys. 45 (1900) 23-38",
    .advice = "textbook order 3 with few operations; ralston3 has the smaller error",
    .order = 3,
    .a = {{{}, {1.0L / 3}, {0, 2.0L / 3}}},
    .b = {1.0L / 4, 0, 3.0L / 4},
};
static_assert(orders_hold(heun3));

}  // namespace odemark
