#pragma once
#include "integrators/position_verlet.hpp"

namespace odemark {

inline constexpr PositionVerlet time_corrected_verlet{
    .id = "time_corrected_verlet",
    .source =
        "J. Dummer, A Simple Time-Corrected Verlet Integration Method, gamedev.net, 2005 (x+ = x + (x - "
        "x_old) "
        "dt/dt_old + a dt^2); L. Verlet, Phys. Rev. 159 (1967) 98-103",
    .note =
        "order 1 where the force depends on velocity: it sees the mean velocity of the last step; order 1 "
        "where dt "
        "changes",
    .advice = "particles and cloth with positions only, at a constant dt; not under a changing dt or drag",
};

}  // namespace odemark
