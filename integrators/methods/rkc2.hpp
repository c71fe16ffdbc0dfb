#pragma once
#include "integrators/stabilised_runge_kutta.hpp"

namespace odemark {

inline constexpr StabilisedRungeKutta rkc2{
    .id = "rkc2",
    .source = "B. P. Sommeijer, L. F. Shampine, J. G. Verwer, J. Comput. Appl. Math. 88 (1998) 315-326",

    .advice =
        "diffusion and strong friction without a Jacobian, 1e-2 to 1e-5: stable to 0.65 stages^2; not for "
        "stiff oscillations",
    .order = 2,
    .embedded_order = 2,
    .family = StabilisedFamily::rkc2,
};

}  // namespace odemark
