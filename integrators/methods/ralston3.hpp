#pragma once
#include "integrators/explicit_runge_kutta.hpp"
#include "integrators/order_conditions.hpp"

namespace odemark {

inline constexpr ExplicitRungeKutta<3> ralston3{
    .id = "ralston3",
    .source = "A. Ralston, Math. Comp. 16 (1962) 431-437",
    .advice =
        "the order-3 default without error control; bogacki_shampine32 is the same step with an estimate",
    .order = 3,
    .a = {{{}, {1.0L / 2}, {0, 3.0L / 4}}},
    .b = {2.0L / 9, 1.0L / 3, 4.0L / 9},
};
static_assert(orders_hold(ralston3));

}  // namespace odemark
