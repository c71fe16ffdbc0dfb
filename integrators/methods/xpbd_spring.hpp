#pragma once
#include "integrators/linearly_implicit_euler.hpp"

namespace odemark {

inline constexpr LinearlyImplicitEuler xpbd_spring{
    .id = "xpbd_spring",
    .source =
        "M. Macklin, M. Mueller, N. Chentanez, XPBD: position-based simulation of compliant constrained "
        "dynamics, "
        "MIG 2016, 49-54, eq. 18 and 26, doi:10.1145/2994258.2994272",
    .linearised_at = LinearlyImplicitEuler::Where::prediction,
    .note =
        "one iteration from the inertial prediction, all coordinates at once: no error of a Gauss-Seidel "
        "sweep",
    .advice =
        "compliant springs that must not blow up; damps as implicit Euler does: take substeps for lively "
        "motion",
};

}  // namespace odemark
