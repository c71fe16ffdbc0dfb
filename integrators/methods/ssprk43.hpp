#pragma once
#include "integrators/explicit_runge_kutta.hpp"
#include "integrators/order_conditions.hpp"

namespace odemark {

inline constexpr ExplicitRungeKutta<4> ssprk43{
    .id = "ssprk43",
    .source = "J. F. B. M. Kraaijevanger, BIT 31 (1991) 482-528, Theorem 9.4",
    .advice =
        "monotone to twice the step of ssprk33 for one more evaluation; long real interval for an order 3",
    .order = 3,
    .a = {{{}, {1.0L / 2}, {1.0L / 2, 1.0L / 2}, {1.0L / 6, 1.0L / 6, 1.0L / 6}}},
    .b = {1.0L / 6, 1.0L / 6, 1.0L / 6, 1.0L / 2},
};
static_assert(orders_hold(ssprk43));

}  // namespace odemark
