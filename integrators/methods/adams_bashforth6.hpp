#pragma once
#include "integrators/methods/gragg_bulirsch_stoer6.hpp"
#include "integrators/multistep.hpp"

namespace odemark {

inline constexpr ExplicitMultistep<6, gragg_bulirsch_stoer6> adams_bashforth6{
    .id = "adams_bashforth6",
    .source = "E. Hairer, S. P. Norsett, G. Wanner, Solving ODEs I, III.1, table 1.1",
    .advice =
        "very smooth, costly right-hand sides at very small steps; limits of 0.09 rule it out elsewhere",
    .order = 6,
    .formula = {.slopes = {4277.0L / 1440, -7923.0L / 1440, 9982.0L / 1440, -7298.0L / 1440, 2877.0L / 1440,
                           -475.0L / 1440}},
};
static_assert(multistep_holds(adams_bashforth6));

}  // namespace odemark
