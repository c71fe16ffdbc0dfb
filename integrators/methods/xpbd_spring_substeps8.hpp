#pragma once
#include "integrators/methods/xpbd_spring.hpp"
#include "integrators/substeps.hpp"

namespace odemark {

inline constexpr Substeps<xpbd_spring, 8> xpbd_spring_substeps8{
    .id = "xpbd_spring_substeps8",
    .source =
        "M. Macklin, K. Storey, M. Lu, P. Terdiman, N. Chentanez, S. Jeschke, M. Mueller, Small steps in "
        "physics "
        "simulation, SCA 2019, doi:10.1145/3309486.3340247 (substeps of one iteration each)",
    .advice = "stiff springs that stay lively; not if one solve a frame is all there is",
};

}  // namespace odemark
