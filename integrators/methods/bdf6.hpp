#pragma once
#include "integrators/methods/linearly_implicit_euler_extrapolation6.hpp"
#include "integrators/multistep.hpp"

namespace odemark {

/// The one-step member of this family is implicit_euler.
inline constexpr ImplicitMultistep<6, linearly_implicit_euler_extrapolation6> bdf6{
    .id = "bdf6",
    .source =
        "C. F. Curtiss, J. O. Hirschfelder, Proc. Natl. Acad. Sci. 38 (1952) 235-243; "
        "E. Hairer, S. P. Norsett, G. Wanner, Solving ODEs I, III.1, eq. 1.22",
    .advice =
        "only for eigenvalues near the negative real axis (A(17.8 degrees)); bdf5 is nearly always the "
        "better choice",
    .order = 6,
    .formula = {.states = {360.0L / 147, -450.0L / 147, 400.0L / 147, -225.0L / 147, 72.0L / 147,
                           -10.0L / 147},
                .next_slope = 60.0L / 147},
};
static_assert(multistep_holds(bdf6));

}  // namespace odemark
