#pragma once
#include "integrators/explicit_runge_kutta.hpp"
#include "integrators/order_conditions.hpp"

namespace odemark {

inline constexpr ExplicitRungeKutta<6> cash_karp54{
    .id = "cash_karp54",
    .source = "J. R. Cash, A. H. Karp, ACM Trans. Math. Software 16 (1990) 201-222",
    .advice = "made for right-hand sides with jumps; dormand_prince54 is more accurate where they are smooth",
    .order = 5,
    .embedded_order = 4,
    .a = {{{},
           {1.0L / 5},
           {3.0L / 40, 9.0L / 40},
           {3.0L / 10, -9.0L / 10, 6.0L / 5},
           {-11.0L / 54, 5.0L / 2, -70.0L / 27, 35.0L / 27},
           {1631.0L / 55296, 175.0L / 512, 575.0L / 13824, 44275.0L / 110592, 253.0L / 4096}}},
    .b = {37.0L / 378, 0, 250.0L / 621, 125.0L / 594, 0, 512.0L / 1771},
    .b_embedded = {2825.0L / 27648, 0, 18575.0L / 48384, 13525.0L / 55296, 277.0L / 14336, 1.0L / 4},
};
static_assert(orders_hold(cash_karp54));

}  // namespace odemark
