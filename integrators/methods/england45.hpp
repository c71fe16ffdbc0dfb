#pragma once
#include "integrators/explicit_runge_kutta.hpp"
#include "integrators/order_conditions.hpp"

namespace odemark {

inline constexpr ExplicitRungeKutta<6> england45{
    .id = "england45",
    .source = "R. England, Comput. J. 12 (1969) 166-170",
    .advice = "propagates order 4; of historical interest, fehlberg54 and dormand_prince54 are better",
    .order = 4,
    .embedded_order = 5,
    .propagates_lower = true,
    .a = {{{},
           {1.0L / 2},
           {1.0L / 4, 1.0L / 4},
           {0, -1, 2},
           {7.0L / 27, 10.0L / 27, 0, 1.0L / 27},
           {28.0L / 625, -1.0L / 5, 546.0L / 625, 54.0L / 625, -378.0L / 625}}},
    .b = {1.0L / 6, 0, 2.0L / 3, 1.0L / 6, 0, 0},
    .b_embedded = {1.0L / 24, 0, 0, 5.0L / 48, 27.0L / 56, 125.0L / 336},
};
static_assert(orders_hold(england45));

}  // namespace odemark
