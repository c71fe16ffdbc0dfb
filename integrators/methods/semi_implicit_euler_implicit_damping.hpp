#pragma once
#include "integrators/damped_euler.hpp"

namespace odemark {

inline constexpr DampedEuler semi_implicit_euler_implicit_damping{
    .id = "semi_implicit_euler_implicit_damping",
    .source =
        "E. Catto, Numerical Methods, GDC 2015 (implicit damping: v+ = (v + h a)/(1 + h d)); the step of "
        "MuJoCo's "
        "Euler with eulerdamp",
    .damping = DampedEuler::Damping::implicit,
    .advice =
        "stiff dampers on soft springs, dt up to 2 (sqrt(1 + zeta^2) + zeta)/omega; not for stiff springs",
};

}  // namespace odemark
