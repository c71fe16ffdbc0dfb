#pragma once
#include "integrators/methods/rk4.hpp"
#include "integrators/substeps.hpp"

namespace odemark {

inline constexpr Substeps<rk4, 2> rk4_substeps2{
    .id = "rk4_substeps2",
    .source = rk4.source,
    .advice = "smooth motion between coarse frames; not for stiff springs",
};

}  // namespace odemark
