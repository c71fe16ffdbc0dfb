#pragma once
#include "integrators/verlet_position_form.hpp"

namespace odemark {

inline constexpr VerletPositionForm verlet_position_form{
    .id = "verlet_position_form",
    .source =
        "L. Verlet, Phys. Rev. 159 (1967) 98-103, eq. 4, doi:10.1103/PhysRev.159.98; with step change as two "
        "Taylor series about x_n have it",
    .order = 2,
    .advice =
        "constraints and cloth, where positions are what is corrected; not in single precision with short "
        "steps: velocities are differences of positions",
};

}  // namespace odemark
