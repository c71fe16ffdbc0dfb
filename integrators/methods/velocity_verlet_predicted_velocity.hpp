#pragma once
#include "integrators/velocity_verlet.hpp"

namespace odemark {

inline constexpr VelocityVerlet velocity_verlet_predicted_velocity{
    .id = "velocity_verlet_predicted_velocity",
    .source =
        "W. C. Swope, H. C. Andersen, P. H. Berens, K. R. Wilson, J. Chem. Phys. 76 (1982) 637-649 (velocity "
        "in the new force: v_n + h a_n)",
    .order = 2,
    .velocity = VelocityVerlet::Velocity::predicted,
    .note = "new force sees v_n + h a_n",
};

}  // namespace odemark
