#pragma once
#include "integrators/methods/bogacki_shampine32.hpp"
#include "integrators/multistep.hpp"

namespace odemark {

inline constexpr ImplicitMultistep<2, bogacki_shampine32> adams_moulton3{
    .id = "adams_moulton3",
    .source =
        "F. R. Moulton, New Methods in Exterior Ballistics, 1926; E. Hairer, S. P. Norsett, G. Wanner, "
        "Solving ODEs I, III.1, table 1.2",
    .advice = "mildly stiff problems (real limit 6) at a fixed step; not for stiff ones: use bdf or radau",
    .order = 3,
    .formula = {.next_slope = 5.0L / 12, .slopes = {8.0L / 12, -1.0L / 12}},
};
static_assert(multistep_holds(adams_moulton3));

}  // namespace odemark
