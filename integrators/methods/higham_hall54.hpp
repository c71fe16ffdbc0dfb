#pragma once
#include "integrators/explicit_runge_kutta.hpp"
#include "integrators/order_conditions.hpp"

namespace odemark {

inline constexpr ExplicitRungeKutta<7> higham_hall54{
    .id = "higham_hall54",
    .source =
        "D. J. Higham, G. Hall, J. Comput. Appl. Math. 29 (1990) 25-33; Hairer & Wanner, Solving ODEs II, "
        "IV.2",
    .advice = "mildly stiff problems: the step settles at the stability limit without rejections",
    .order = 5,
    .embedded_order = 4,
    .a = {{{},
           {2.0L / 9},
           {1.0L / 12, 1.0L / 4},
           {1.0L / 8, 0, 3.0L / 8},
           {91.0L / 500, -27.0L / 100, 78.0L / 125, 8.0L / 125},
           {-11.0L / 20, 27.0L / 20, 12.0L / 5, -36.0L / 5, 5},
           {1.0L / 12, 0, 27.0L / 32, -4.0L / 3, 125.0L / 96, 5.0L / 48}}},
    .b = {1.0L / 12, 0, 27.0L / 32, -4.0L / 3, 125.0L / 96, 5.0L / 48, 0},
    .b_embedded = {2.0L / 15, 0, 27.0L / 80, -2.0L / 15, 25.0L / 48, 1.0L / 24, 1.0L / 10},
};
static_assert(orders_hold(higham_hall54));
static_assert(higham_hall54.first_same_as_last());

}  // namespace odemark
