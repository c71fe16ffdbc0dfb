#pragma once
#include "integrators/extrapolation.hpp"

namespace odemark {

inline constexpr FixedExtrapolation<GraggRule, 3> gragg_bulirsch_stoer6{
    .id = "gragg_bulirsch_stoer6",
    .source =
        "W. B. Gragg, SIAM J. Numer. Anal. 2 (1965) 384-403; E. Hairer, S. P. Norsett, G. Wanner, Solving "
        "ODEs I, II.9",
    .advice = "starts multistep methods of order 6; for smooth problems a pair of order 6 is cheaper",
};
static_assert(gragg_bulirsch_stoer6.order == 6 && gragg_bulirsch_stoer6.embedded_order == 4);

}  // namespace odemark
