#pragma once
#include "integrators/methods/heun.hpp"
#include "integrators/multistep.hpp"

namespace odemark {

/// The two-step midpoint rule, not the splitting of the same nickname (that one is stormer_verlet).
inline constexpr ExplicitMultistep<2, heun> leapfrog{
    .id = "leapfrog",
    .source = "E. Hairer, S. P. Norsett, G. Wanner, Solving ODEs I, III.1, eq. 1.13",
    .advice =
        "undamped waves and oscillators (to w dt = 1) at one evaluation per step; any damping makes it grow",
    .order = 2,
    .formula = {.states = {0, 1}, .slopes = {2}},
};
static_assert(multistep_holds(leapfrog));

}  // namespace odemark
