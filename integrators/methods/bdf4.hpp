#pragma once
#include "integrators/methods/linearly_implicit_euler_extrapolation4.hpp"
#include "integrators/multistep.hpp"

namespace odemark {

/// The one-step member of this family is implicit_euler.
inline constexpr ImplicitMultistep<4, linearly_implicit_euler_extrapolation4> bdf4{
    .id = "bdf4",
    .source =
        "C. F. Curtiss, J. O. Hirschfelder, Proc. Natl. Acad. Sci. 38 (1952) 235-243; "
        "E. Hairer, S. P. Norsett, G. Wanner, Solving ODEs I, III.1, eq. 1.22",
    .advice =
        "stiff, smooth decay at a fixed step; not for eigenvalues within 17 degrees of the imaginary axis",
    .order = 4,
    .formula = {.states = {48.0L / 25, -36.0L / 25, 16.0L / 25, -3.0L / 25}, .next_slope = 12.0L / 25},
};
static_assert(multistep_holds(bdf4));

}  // namespace odemark
