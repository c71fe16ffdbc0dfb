#pragma once
#include "integrators/methods/linearly_implicit_euler_extrapolation6.hpp"
#include "integrators/multistep.hpp"

namespace odemark {

/// The one-step member of this family is implicit_euler.
inline constexpr ImplicitMultistep<5, linearly_implicit_euler_extrapolation6> bdf5{
    .id = "bdf5",
    .source =
        "C. F. Curtiss, J. O. Hirschfelder, Proc. Natl. Acad. Sci. 38 (1952) 235-243; "
        "E. Hairer, S. P. Norsett, G. Wanner, Solving ODEs I, III.1, eq. 1.22",
    .advice =
        "stiff, smooth decay to high accuracy; not for eigenvalues within 38 degrees of the imaginary axis",
    .order = 5,
    .formula = {.states = {300.0L / 137, -300.0L / 137, 200.0L / 137, -75.0L / 137, 12.0L / 137},
                .next_slope = 60.0L / 137},
};
static_assert(multistep_holds(bdf5));

}  // namespace odemark
