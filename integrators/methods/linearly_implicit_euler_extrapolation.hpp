#pragma once
#include "integrators/extrapolation.hpp"

namespace odemark {

inline constexpr VariableExtrapolation<LinearlyImplicitRule> linearly_implicit_euler_extrapolation{
    .id = "linearly_implicit_euler_extrapolation",
    .source = "P. Deuflhard, SIAM Rev. 27 (1985) 505-535; E. Hairer, G. Wanner, Solving ODEs II, IV.9",
    .advice =
        "stiff problems to high accuracy with few, cheap Jacobians; loose tolerances are served better by "
        "bdf",
};

}  // namespace odemark
