#pragma once
#include "integrators/exponential.hpp"

namespace odemark {

inline constexpr ExponentialRungeKutta<4> lawson4{
    .id = "lawson4",
    .source =
        "J. D. Lawson, SIAM J. Numer. Anal. 4 (1967) 372-380: the classical Runge-Kutta method on e^(-t L) y",
    .advice =
        "an oscillating linear part with a slow, small rest; a strong rest loses order as h L grows: etdrk4",
    .order = 4,
    .c = {0, 1.0L / 2, 1.0L / 2, 1},
    .a = {{{},
           {{0.5L * phi(0, 0.5L) - 0.5L * phi(1, 0.5L)}},
           {{0.5L * phi(0, 0) - 0.5L * phi(1, 0.5L), 0.5L * phi(0, 0)}},
           {{phi(0, 0.5L) - phi(1), {}, phi(0, 0.5L)}}}},
    .b = {{1.0L / 6 * phi(0) + 2.0L / 3 * phi(0, 0.5L) + 1.0L / 6 * phi(0, 0) - phi(1),
           1.0L / 3 * phi(0, 0.5L), 1.0L / 3 * phi(0, 0.5L), 1.0L / 6 * phi(0, 0)}},
};
static_assert(orders_hold(lawson4));

}  // namespace odemark
