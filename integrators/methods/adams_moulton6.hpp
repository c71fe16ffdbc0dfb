#pragma once
#include "integrators/methods/gragg_bulirsch_stoer6.hpp"
#include "integrators/multistep.hpp"

namespace odemark {

inline constexpr ImplicitMultistep<5, gragg_bulirsch_stoer6> adams_moulton6{
    .id = "adams_moulton6",
    .source =
        "F. R. Moulton, New Methods in Exterior Ballistics, 1926; E. Hairer, S. P. Norsett, G. Wanner, "
        "Solving ODEs I, III.1, table 1.2",
    .advice = "accurate fixed steps on very smooth problems (real limit 1.2); not for stiff ones",
    .order = 6,
    .formula = {.next_slope = 475.0L / 1440,
                .slopes = {1427.0L / 1440, -798.0L / 1440, 482.0L / 1440, -173.0L / 1440, 27.0L / 1440}},
};
static_assert(multistep_holds(adams_moulton6));

}  // namespace odemark
