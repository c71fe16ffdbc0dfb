#pragma once
#include "integrators/methods/rk4.hpp"
#include "integrators/multistep.hpp"

namespace odemark {

inline constexpr ImplicitMultistep<3, rk4> adams_moulton4{
    .id = "adams_moulton4",
    .source =
        "F. R. Moulton, New Methods in Exterior Ballistics, 1926; E. Hairer, S. P. Norsett, G. Wanner, "
        "Solving ODEs I, III.1, table 1.2",
    .advice =
        "a corrector to learn from, real limit 3; its Newton iteration rarely pays over "
        "adams_bashforth_moulton44",
    .order = 4,
    .formula = {.next_slope = 9.0L / 24, .slopes = {19.0L / 24, -5.0L / 24, 1.0L / 24}},
};
static_assert(multistep_holds(adams_moulton4));

}  // namespace odemark
