#pragma once
#include "integrators/explicit_runge_kutta.hpp"
#include "integrators/order_conditions.hpp"

namespace odemark {

inline constexpr ExplicitRungeKutta<6> nystrom5{
    .id = "nystrom5",
    .source = "E. J. Nystrom, Acta Soc. Sci. Fenn. 50 (1925) 1-55 (Kutta 1901, corrected)",
    .advice = "the first correct order 5; of historical interest beside dormand_prince54",
    .order = 5,
    .a = {{{},
           {1.0L / 3},
           {4.0L / 25, 6.0L / 25},
           {1.0L / 4, -3, 15.0L / 4},
           {2.0L / 27, 10.0L / 9, -50.0L / 81, 8.0L / 81},
           {2.0L / 25, 12.0L / 25, 2.0L / 15, 8.0L / 75, 0}}},
    .b = {23.0L / 192, 0, 125.0L / 192, 0, -27.0L / 64, 125.0L / 192},
};
static_assert(orders_hold(nystrom5));

}  // namespace odemark
