#pragma once
#include "integrators/explicit_runge_kutta.hpp"
#include "integrators/order_conditions.hpp"

namespace odemark {

inline constexpr ExplicitRungeKutta<10> ssprk104{
    .id = "ssprk104",
    .source = "D. I. Ketcheson, SIAM J. Sci. Comput. 30 (2008) 2113-2136",
    .advice =
        "order 4 that keeps monotonicity (six Euler steps) and has a long real interval; ten evaluations",
    .order = 4,
    .a = {{{},
           {1.0L / 6},
           {1.0L / 6, 1.0L / 6},
           {1.0L / 6, 1.0L / 6, 1.0L / 6},
           {1.0L / 6, 1.0L / 6, 1.0L / 6, 1.0L / 6},
           {1.0L / 15, 1.0L / 15, 1.0L / 15, 1.0L / 15, 1.0L / 15},
           {1.0L / 15, 1.0L / 15, 1.0L / 15, 1.0L / 15, 1.0L / 15, 1.0L / 6},
           {1.0L / 15, 1.0L / 15, 1.0L / 15, 1.0L / 15, 1.0L / 15, 1.0L / 6, 1.0L / 6},
           {1.0L / 15, 1.0L / 15, 1.0L / 15, 1.0L / 15, 1.0L / 15, 1.0L / 6, 1.0L / 6, 1.0L / 6},
           {1.0L / 15, 1.0L / 15, 1.0L / 15, 1.0L / 15, 1.0L / 15, 1.0L / 6, 1.0L / 6, 1.0L / 6, 1.0L / 6}}},
    .b = {1.0L / 10, 1.0L / 10, 1.0L / 10, 1.0L / 10, 1.0L / 10, 1.0L / 10, 1.0L / 10, 1.0L / 10, 1.0L / 10,
          1.0L / 10},
};
static_assert(orders_hold(ssprk104));

}  // namespace odemark
