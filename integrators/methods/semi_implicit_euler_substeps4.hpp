#pragma once
#include "integrators/methods/semi_implicit_euler.hpp"
#include "integrators/substeps.hpp"

namespace odemark {

inline constexpr Substeps<semi_implicit_euler, 4> semi_implicit_euler_substeps4{
    .id = "semi_implicit_euler_substeps4",
    .source =
        "E. Catto, Solver2D, box2d.org, 2024 (four substeps of semi-implicit Euler to a frame, as Box2D 3 "
        "takes)",
    .advice =
        "springs four times as stiff at the same frame rate; not where forces are dear: four evaluations a "
        "step",
};

}  // namespace odemark
