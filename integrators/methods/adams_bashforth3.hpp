#pragma once
#include "integrators/methods/bogacki_shampine32.hpp"
#include "integrators/multistep.hpp"

namespace odemark {

inline constexpr ExplicitMultistep<3, bogacki_shampine32> adams_bashforth3{
    .id = "adams_bashforth3",
    .source = "E. Hairer, S. P. Norsett, G. Wanner, Solving ODEs I, III.1, table 1.1",
    .advice =
        "the cheapest step that holds an undamped oscillator (to w dt = 0.72); not for stiff or switching "
        "forces",
    .order = 3,
    .formula = {.slopes = {23.0L / 12, -16.0L / 12, 5.0L / 12}},
};
static_assert(multistep_holds(adams_bashforth3));

}  // namespace odemark
