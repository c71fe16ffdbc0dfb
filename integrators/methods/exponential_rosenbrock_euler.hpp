#pragma once
#include "integrators/exponential.hpp"

namespace odemark {

inline constexpr ExponentialRungeKutta<1, LinearPart::jacobian> exponential_rosenbrock_euler{
    .id = "exponential_rosenbrock_euler",
    .source =
        "D. A. Pope, Comm. ACM 6 (1963) 491-493; with the time derivative: M. Hochbruck, A. Ostermann, J. "
        "Schweitzer, SIAM J. "
        "Numer. Anal. 47 (2009) 786-803, eq. 2.8",
    .advice =
        "fast linear oscillations and slow drift of their rate at 1e-2 to 1e-4; a matrix exponential every "
        "step",
    .order = 2,

};
static_assert(orders_hold(exponential_rosenbrock_euler));

}  // namespace odemark
