#pragma once
#include "integrators/explicit_runge_kutta.hpp"
#include "integrators/order_conditions.hpp"

namespace odemark {

inline constexpr ExplicitRungeKutta<3> kutta3{
    .id = "kutta3",
    .source = "W. Kutta, Z. Math. Phys. 46 (1901) 435-453",
    .advice = "textbook order 3 (Simpson on quadratures); ralston3 has the smaller error",
    .order = 3,
    .a = {{{}, {1.0L / 2}, {-1, 2}}},
    .b = {1.0L / 6, 2.0L / 3, 1.0L / 6},
};
static_assert(orders_hold(kutta3));

}  // namespace odemark
