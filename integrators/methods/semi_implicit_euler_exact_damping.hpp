#pragma once
#include "integrators/damped_euler.hpp"

namespace odemark {

inline constexpr DampedEuler semi_implicit_euler_exact_damping{
    .id = "semi_implicit_euler_exact_damping",
    .source =
        "J. D. Lawson, SIAM J. Numer. Anal. 4 (1967) 372-380, doi:10.1137/0704033 (the linear part by its "
        "exponential); Bullet's btRigidBody::applyDamping multiplies by pow(1 - damping, dt)",
    .damping = DampedEuler::Damping::exact,
    .advice =
        "drag that must not depend on the frame rate; not with stiff springs: dt below sqrt(2)/omega when "
        "strongly "
        "damped",
};

}  // namespace odemark
