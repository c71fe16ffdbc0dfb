#pragma once
#include "integrators/explicit_runge_kutta.hpp"
#include "integrators/order_conditions.hpp"

namespace odemark {

inline constexpr ExplicitRungeKutta<4> rk38{
    .id = "rk38",
    .source = "W. Kutta, Z. Math. Phys. 46 (1901) 435-453 (the 3/8 rule)",
    .advice = "order 4 with a slightly smaller error than rk4 for a few more operations",
    .order = 4,
    .a = {{{}, {1.0L / 3}, {-1.0L / 3, 1}, {1, -1, 1}}},
    .b = {1.0L / 8, 3.0L / 8, 3.0L / 8, 1.0L / 8},
};
static_assert(orders_hold(rk38));

}  // namespace odemark
