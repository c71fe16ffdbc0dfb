#pragma once
#include "integrators/stabilised_runge_kutta.hpp"

namespace odemark {

inline constexpr StabilisedRungeKutta rock4{
    .id = "rock4",
    .source = "A. Abdulle, SIAM J. Sci. Comput. 23 (2002) 2041-2054",
    .note =
        "zeros of the weights and last stages recomputed (damping 0.95), not the tables of the published "
        "code",
    .advice =
        "diffusion to 1e-3 to 1e-7 without a Jacobian: stable to 0.35 stages^2; not for stiff oscillations",
    .order = 4,
    .embedded_order = 3,
    .family = StabilisedFamily::rock4,
};

}  // namespace odemark
