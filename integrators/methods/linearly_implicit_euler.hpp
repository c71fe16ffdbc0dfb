#pragma once
#include "integrators/linearly_implicit_euler.hpp"

namespace odemark {

inline constexpr LinearlyImplicitEuler linearly_implicit_euler{
    .id = "linearly_implicit_euler",
    .source =
        "D. Baraff, A. Witkin, Large steps in cloth simulation, SIGGRAPH 98, 43-54, eq. 6, "
        "doi:10.1145/280814.280821",
    .linearised_at = LinearlyImplicitEuler::Where::start,
    .advice =
        "stiff cloth and springs at any dt for one solve a step; not where energy matters: it damps heavily",
};

}  // namespace odemark
