#pragma once
#include "integrators/explicit_runge_kutta.hpp"
#include "integrators/order_conditions.hpp"

namespace odemark {

inline constexpr ExplicitRungeKutta<2> explicit_midpoint{
    .id = "explicit_midpoint",
    .source = "C. Runge, Math. Ann. 46 (1895) 167-178",
    .advice = "order 2 in two evaluations; ralston2 has the smaller error bound",
    .order = 2,
    .a = {{{}, {1.0L / 2}}},
    .b = {0, 1},
};
static_assert(orders_hold(explicit_midpoint));

}  // namespace odemark
