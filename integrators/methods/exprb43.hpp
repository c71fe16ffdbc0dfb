#pragma once
#include "integrators/exponential.hpp"

namespace odemark {

inline constexpr ExponentialRungeKutta<3, LinearPart::jacobian> exprb43{
    .id = "exprb43",
    .source = "M. Hochbruck, A. Ostermann, J. Schweitzer, SIAM J. Numer. Anal. 47 (2009) 786-803, table 2",
    .advice =
        "stiff or oscillating problems of few equations at 1e-5 and below, three evaluations and a matrix "
        "exponential a step",
    .note = "steps over a singularity: with fixed steps it returns as a finite number",
    .order = 4,
    .embedded_order = 3,
    .jumps_over_poles = true,
    .c = {0, 1.0L / 2, 1},
    .a = {{{}, {}, {{{}, phi(1)}}}},
    .b = {{{}, 16 * phi(3) - 48 * phi(4), 12 * phi(4) - 2 * phi(3)}},
    .b_embedded = {{{}, 16 * phi(3), -2 * phi(3)}},
};
static_assert(orders_hold(exprb43));

}  // namespace odemark
