#pragma once
#include "integrators/velocity_verlet.hpp"

namespace odemark {

inline constexpr VelocityVerlet velocity_verlet_implicit_velocity{
    .id = "velocity_verlet_implicit_velocity",
    .source =
        "W. C. Swope, H. C. Andersen, P. H. Berens, K. R. Wilson, J. Chem. Phys. 76 (1982) 637-649 (velocity "
        "in the new force: v_{n+1}, solved for)",
    .order = 2,
    .velocity = VelocityVerlet::Velocity::implicit,
    .note = "new force sees v_{n+1}",
};

}  // namespace odemark
