#pragma once
#include "integrators/diagonally_implicit_runge_kutta.hpp"
#include "integrators/order_conditions.hpp"

namespace odemark {

inline constexpr DiagonallyImplicitRungeKutta<5> sdirk43{
    .id = "sdirk43",
    .source = "E. Hairer, G. Wanner, Solving ODEs II (1996), IV.6, table 6.5 (SDIRK4)",
    .order = 4,
    .embedded_order = 3,
    .a = {{{1.0L / 4},
           {1.0L / 2, 1.0L / 4},
           {17.0L / 50, -1.0L / 25, 1.0L / 4},
           {371.0L / 1360, -137.0L / 2720, 15.0L / 544, 1.0L / 4},
           {25.0L / 24, -49.0L / 48, 125.0L / 16, -85.0L / 12, 1.0L / 4}}},
    .b = {25.0L / 24, -49.0L / 48, 125.0L / 16, -85.0L / 12, 1.0L / 4},
    .b_embedded = {59.0L / 48, -17.0L / 96, 225.0L / 32, -85.0L / 12, 0},
    .filter_estimate = true,
    .advice = "stiff problems at 1e-3 to 1e-5, L-stable; large coefficients, esdirk43 is the smoother choice",
};
static_assert(orders_hold(sdirk43));

}  // namespace odemark
