#pragma once
#include "integrators/stabilised_runge_kutta.hpp"

namespace odemark {

inline constexpr StabilisedRungeKutta rkc1{
    .id = "rkc1",
    .source =
        "P. J. van der Houwen, B. P. Sommeijer, ZAMM 60 (1980) 479-485; J. G. Verwer, Appl. Numer. Math. 22 "
        "(1996) 359-379",

    .advice =
        "diffusion at fixed steps where first order is enough: stable to 1.93 stages^2 on the real axis; not "
        "for oscillations",
    .order = 1,

    .family = StabilisedFamily::rkc1,
};

}  // namespace odemark
