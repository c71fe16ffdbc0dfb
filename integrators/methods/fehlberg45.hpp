#pragma once
#include "integrators/explicit_runge_kutta.hpp"
#include "integrators/order_conditions.hpp"

namespace odemark {

inline constexpr ExplicitRungeKutta<6> fehlberg45{
    .id = "fehlberg45",
    .source = "E. Fehlberg, NASA TR R-315 (1969), Table III, order 4 propagated",
    .advice =
        "as Fehlberg meant it, error estimate of what is kept; fehlberg54 is more accurate at the same cost",
    .order = 4,
    .embedded_order = 5,
    .propagates_lower = true,
    .a = {{{},
           {1.0L / 4},
           {3.0L / 32, 9.0L / 32},
           {1932.0L / 2197, -7200.0L / 2197, 7296.0L / 2197},
           {439.0L / 216, -8, 3680.0L / 513, -845.0L / 4104},
           {-8.0L / 27, 2, -3544.0L / 2565, 1859.0L / 4104, -11.0L / 40}}},
    .b = {25.0L / 216, 0, 1408.0L / 2565, 2197.0L / 4104, -1.0L / 5, 0},
    .b_embedded = {16.0L / 135, 0, 6656.0L / 12825, 28561.0L / 56430, -9.0L / 50, 2.0L / 55},
};
static_assert(orders_hold(fehlberg45));

}  // namespace odemark
