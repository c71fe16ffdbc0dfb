#pragma once
#include "integrators/stabilised_runge_kutta.hpp"

namespace odemark {

inline constexpr StabilisedRungeKutta rock2{
    .id = "rock2",
    .source = "A. Abdulle, A. A. Medovikov, Numer. Math. 90 (2001) 1-18",
    .note = "zeros of the weights recomputed (damping 0.95), not the tables of the published code",
    .advice =
        "diffusion and strong friction without a Jacobian: stable to 0.81 stages^2, the longest of order 2; "
        "not for stiff oscillations",
    .order = 2,
    .embedded_order = 1,
    .family = StabilisedFamily::rock2,
};

}  // namespace odemark
