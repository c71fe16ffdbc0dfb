#pragma once
#include "integrators/fully_implicit_runge_kutta.hpp"

namespace odemark {

inline constexpr FullyImplicitRungeKutta<2> radau_ia3{
    .id = "radau_ia3",
    .source =
        "B. L. Ehle, SIAM J. Math. Anal. 4 (1973) 671-680; E. Hairer, G. Wanner, Solving ODEs II (1996), "
        "IV.5, table 5.3",
    .order = 3,
    .jumps_over_poles = true,
    .a = {{{1.0L / 4, -1.0L / 4}, {1.0L / 4, 5.0L / 12}}},
    .b = {1.0L / 4, 3.0L / 4},
    .note = "steps over a singularity: with fixed steps it returns as a finite number",
    .advice = "L-stable of order 3; radau_iia3 is better where f is stiff, being stiffly accurate",
};
static_assert(orders_hold(radau_ia3));

}  // namespace odemark
