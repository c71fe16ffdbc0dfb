// A method that the suite does not have: its tableau is all there is to write.
#pragma once
#include "integrators/explicit_runge_kutta.hpp"
#include "integrators/order_conditions.hpp"

namespace consumer {

inline constexpr odemark::ExplicitRungeKutta<3> my_ralston3{
    .id = "my_ralston3",
    .source = "A. Ralston, Math. Comp. 16 (1962) 431-437",
    .order = 3,
    .a = {{{}, {1.0L / 2}, {0, 3.0L / 4}}},
    .b = {2.0L / 9, 1.0L / 3, 4.0L / 9},
};
static_assert(orders_hold(my_ralston3));

}  // namespace consumer
