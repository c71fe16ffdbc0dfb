#pragma once
#include "integrators/velocity_verlet.hpp"

namespace odemark {

inline constexpr VelocityVerlet velocity_verlet_old_velocity{
    .id = "velocity_verlet_old_velocity",
    .source =
        "W. C. Swope, H. C. Andersen, P. H. Berens, K. R. Wilson, J. Chem. Phys. 76 (1982) 637-649 (velocity "
        "in the new force: v_n)",
    .order = 2,
    .velocity = VelocityVerlet::Velocity::old,
    .note = "new force sees v_n: order 1 where the force depends on velocity",
};

}  // namespace odemark
