#pragma once
#include "integrators/explicit_runge_kutta.hpp"
#include "integrators/order_conditions.hpp"

namespace odemark {

inline constexpr ExplicitRungeKutta<5> zonneveld43{
    .id = "zonneveld43",
    .source = "J. A. Zonneveld, Automatic Numerical Integration, Math. Centre Tracts 8, Amsterdam 1964",
    .advice = "rk4 with an estimate, for comparison; the embedded formula is far less stable than the step",
    .order = 4,
    .embedded_order = 3,
    .a = {{{}, {1.0L / 2}, {0, 1.0L / 2}, {0, 0, 1}, {5.0L / 32, 7.0L / 32, 13.0L / 32, -1.0L / 32}}},
    .b = {1.0L / 6, 1.0L / 3, 1.0L / 3, 1.0L / 6, 0},
    .b_embedded = {-1.0L / 2, 7.0L / 3, 7.0L / 3, 13.0L / 6, -16.0L / 3},
};
static_assert(orders_hold(zonneveld43));

}  // namespace odemark
