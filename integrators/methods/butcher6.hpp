#pragma once
#include "integrators/explicit_runge_kutta.hpp"
#include "integrators/order_conditions.hpp"

namespace odemark {

inline constexpr ExplicitRungeKutta<7> butcher6{
    .id = "butcher6",
    .source = "J. C. Butcher, J. Austral. Math. Soc. 4 (1964) 179-194",
    .advice = "order 6 in seven evaluations with simple coefficients, fixed steps",
    .order = 6,
    .a = {{{},
           {1.0L / 3},
           {0, 2.0L / 3},
           {1.0L / 12, 1.0L / 3, -1.0L / 12},
           {-1.0L / 16, 9.0L / 8, -3.0L / 16, -3.0L / 8},
           {0, 9.0L / 8, -3.0L / 8, -3.0L / 4, 1.0L / 2},
           {9.0L / 44, -9.0L / 11, 63.0L / 44, 18.0L / 11, 0, -16.0L / 11}}},
    .b = {11.0L / 120, 0, 27.0L / 40, 27.0L / 40, -4.0L / 15, -4.0L / 15, 11.0L / 120},
};
static_assert(orders_hold(butcher6));

}  // namespace odemark
