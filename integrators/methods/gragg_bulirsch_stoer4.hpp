#pragma once
#include "integrators/extrapolation.hpp"

namespace odemark {

inline constexpr FixedExtrapolation<GraggRule, 2> gragg_bulirsch_stoer4{
    .id = "gragg_bulirsch_stoer4",
    .source =
        "W. B. Gragg, SIAM J. Numer. Anal. 2 (1965) 384-403; E. Hairer, S. P. Norsett, G. Wanner, Solving "
        "ODEs I, II.9",
    .advice = "the order for teaching: rk4 does the same with less",
};
static_assert(gragg_bulirsch_stoer4.order == 4 && gragg_bulirsch_stoer4.embedded_order == 2);

}  // namespace odemark
