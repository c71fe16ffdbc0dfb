#pragma once
#include "integrators/methods/dormand_prince54.hpp"
#include "integrators/multistep.hpp"

namespace odemark {

inline constexpr ExplicitMultistep<5, dormand_prince54> adams_bashforth5{
    .id = "adams_bashforth5",
    .source = "E. Hairer, S. P. Norsett, G. Wanner, Solving ODEs I, III.1, table 1.1",
    .advice =
        "smooth, costly right-hand sides at small steps; not for damped problems: its real limit is 0.16",
    .order = 5,
    .formula = {.slopes = {1901.0L / 720, -2774.0L / 720, 2616.0L / 720, -1274.0L / 720, 251.0L / 720}},
};
static_assert(multistep_holds(adams_bashforth5));

}  // namespace odemark
