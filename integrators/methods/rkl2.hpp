#pragma once
#include "integrators/stabilised_runge_kutta.hpp"

namespace odemark {

inline constexpr StabilisedRungeKutta rkl2{
    .id = "rkl2",
    .source = "C. D. Meyer, D. S. Balsara, T. D. Aslam, J. Comput. Phys. 257 (2014) 594-626",
    .note = "error estimate as in rkc2",
    .advice =
        "diffusion with variable coefficients, monotone where rkc2 is not; stable to 0.5 stages^2; not for "
        "stiff oscillations",
    .order = 2,
    .embedded_order = 2,
    .family = StabilisedFamily::rkl2,
};

}  // namespace odemark
