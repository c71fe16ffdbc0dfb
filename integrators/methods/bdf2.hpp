#pragma once
#include "integrators/methods/sdirk2.hpp"
#include "integrators/multistep.hpp"

namespace odemark {

/// The one-step member of this family is implicit_euler.
inline constexpr ImplicitMultistep<2, sdirk2> bdf2{
    .id = "bdf2",
    .source =
        "C. F. Curtiss, J. O. Hirschfelder, Proc. Natl. Acad. Sci. 38 (1952) 235-243; "
        "E. Hairer, S. P. Norsett, G. Wanner, Solving ODEs I, III.1, eq. 1.22",
    .advice =
        "stiff problems at a fixed step: L-stable, one solve per step; damps oscillations it does not "
        "resolve",
    .order = 2,
    .formula = {.states = {4.0L / 3, -1.0L / 3}, .next_slope = 2.0L / 3},
};
static_assert(multistep_holds(bdf2));

}  // namespace odemark
