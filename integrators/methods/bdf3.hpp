#pragma once
#include "integrators/methods/linearly_implicit_euler_extrapolation4.hpp"
#include "integrators/multistep.hpp"

namespace odemark {

/// The one-step member of this family is implicit_euler.
inline constexpr ImplicitMultistep<3, linearly_implicit_euler_extrapolation4> bdf3{
    .id = "bdf3",
    .source =
        "C. F. Curtiss, J. O. Hirschfelder, Proc. Natl. Acad. Sci. 38 (1952) 235-243; "
        "E. Hairer, S. P. Norsett, G. Wanner, Solving ODEs I, III.1, eq. 1.22",
    .advice =
        "stiff, smooth decay at a fixed step; not for eigenvalues within 4 degrees of the imaginary axis",
    .order = 3,
    .formula = {.states = {18.0L / 11, -9.0L / 11, 2.0L / 11}, .next_slope = 6.0L / 11},
};
static_assert(multistep_holds(bdf3));

}  // namespace odemark
