#pragma once
#include "integrators/exponential.hpp"

namespace odemark {

inline constexpr ExponentialRungeKutta<5> hochbruck_ostermann4{
    .id = "hochbruck_ostermann4",
    .source = "M. Hochbruck, A. Ostermann, SIAM J. Numer. Anal. 43 (2005) 1069-1090, eq. 5.19",
    .advice =
        "keeps order 4 however stiff the linear part, at five evaluations a step; etdrk4 where dt is small "
        "anyway",
    .order = 4,
    .c = {0, 1.0L / 2, 1.0L / 2, 1, 1.0L / 2},
    .a = {{{},
           {},
           {{{}, phi(2, 0.5L)}},
           {{{}, phi(2), phi(2)}},
           {{{},
             0.5L * phi(2, 0.5L) - phi(3) + 0.25L * phi(2) - 0.5L * phi(3, 0.5L),
             0.5L * phi(2, 0.5L) - phi(3) + 0.25L * phi(2) - 0.5L * phi(3, 0.5L),
             phi(3) - 0.25L * phi(2, 0.5L) - 0.25L * phi(2) + 0.5L * phi(3, 0.5L)}}}},
    .b = {{{}, {}, {}, 4 * phi(3) - phi(2), 4 * phi(2) - 8 * phi(3)}},
};
static_assert(orders_hold(hochbruck_ostermann4));

}  // namespace odemark
