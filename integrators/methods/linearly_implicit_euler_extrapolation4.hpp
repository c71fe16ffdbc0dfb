#pragma once
#include "integrators/extrapolation.hpp"

namespace odemark {

inline constexpr FixedExtrapolation<LinearlyImplicitRule, 4> linearly_implicit_euler_extrapolation4{
    .id = "linearly_implicit_euler_extrapolation4",
    .source = "P. Deuflhard, SIAM Rev. 27 (1985) 505-535; E. Hairer, G. Wanner, Solving ODEs II, IV.9",
    .note = "steps over a singularity: with fixed steps it returns as a finite number",
    .advice =
        "starts bdf3 and bdf4: keeps stiff problems alive through the first steps; otherwise use a "
        "Rosenbrock method",
    .jumps_over_poles = true,
};
static_assert(linearly_implicit_euler_extrapolation4.order == 4 &&
              linearly_implicit_euler_extrapolation4.embedded_order == 3);

}  // namespace odemark
