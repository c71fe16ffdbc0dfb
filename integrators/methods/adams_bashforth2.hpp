#pragma once
#include "integrators/methods/heun.hpp"
#include "integrators/multistep.hpp"

namespace odemark {

inline constexpr ExplicitMultistep<2, heun> adams_bashforth2{
    .id = "adams_bashforth2",
    .source = "E. Hairer, S. P. Norsett, G. Wanner, Solving ODEs I, III.1, table 1.1",
    .advice =
        "one evaluation per step for smooth, damped motion; not for undamped oscillators, where it always "
        "grows",
    .order = 2,
    .formula = {.slopes = {3.0L / 2, -1.0L / 2}},
};
static_assert(multistep_holds(adams_bashforth2));

}  // namespace odemark
