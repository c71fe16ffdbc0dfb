#pragma once
#include "integrators/methods/dormand_prince54.hpp"
#include "integrators/multistep.hpp"

namespace odemark {

inline constexpr ImplicitMultistep<4, dormand_prince54> adams_moulton5{
    .id = "adams_moulton5",
    .source =
        "F. R. Moulton, New Methods in Exterior Ballistics, 1926; E. Hairer, S. P. Norsett, G. Wanner, "
        "Solving ODEs I, III.1, table 1.2",
    .advice = "accurate fixed steps on smooth problems (real limit 1.8); not for stiff ones",
    .order = 5,
    .formula = {.next_slope = 251.0L / 720,
                .slopes = {646.0L / 720, -264.0L / 720, 106.0L / 720, -19.0L / 720}},
};
static_assert(multistep_holds(adams_moulton5));

}  // namespace odemark
