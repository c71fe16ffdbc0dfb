#pragma once
#include "integrators/exponential.hpp"

namespace odemark {

inline constexpr ExponentialRungeKutta<2, LinearPart::jacobian> exprb32{
    .id = "exprb32",
    .source = "M. Hochbruck, A. Ostermann, J. Schweitzer, SIAM J. Numer. Anal. 47 (2009) 786-803, table 1",
    .advice =
        "stiff or oscillating problems of few equations at 1e-3 to 1e-5, two evaluations and a matrix "
        "exponential a step",
    .order = 3,
    .embedded_order = 2,
    .c = {0, 1},
    .b = {{{}, 2 * phi(3)}},
};
static_assert(orders_hold(exprb32));

}  // namespace odemark
