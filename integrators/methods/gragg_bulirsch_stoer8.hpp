#pragma once
#include "integrators/extrapolation.hpp"

namespace odemark {

inline constexpr FixedExtrapolation<GraggRule, 4> gragg_bulirsch_stoer8{
    .id = "gragg_bulirsch_stoer8",
    .source =
        "W. B. Gragg, SIAM J. Numer. Anal. 2 (1965) 384-403; E. Hairer, S. P. Norsett, G. Wanner, Solving "
        "ODEs I, II.9",
    .advice = "smooth problems at fixed steps to 1e-10; not for stiff ones",
};
static_assert(gragg_bulirsch_stoer8.order == 8 && gragg_bulirsch_stoer8.embedded_order == 6);

}  // namespace odemark
