#pragma once
#include "integrators/extrapolation.hpp"

namespace odemark {

inline constexpr FixedExtrapolation<LinearlyImplicitRule, 6> linearly_implicit_euler_extrapolation6{
    .id = "linearly_implicit_euler_extrapolation6",
    .source = "P. Deuflhard, SIAM Rev. 27 (1985) 505-535; E. Hairer, G. Wanner, Solving ODEs II, IV.9",
    .note = "steps over a singularity: with fixed steps it returns as a finite number",
    .advice = "starts bdf5 and bdf6 on stiff problems; otherwise use the version that chooses its order",
    .jumps_over_poles = true,
};
static_assert(linearly_implicit_euler_extrapolation6.order == 6 &&
              linearly_implicit_euler_extrapolation6.embedded_order == 5);

}  // namespace odemark
