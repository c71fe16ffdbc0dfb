#pragma once
#include "integrators/extrapolation.hpp"

namespace odemark {

inline constexpr FixedExtrapolation<GraggRule, 5> gragg_bulirsch_stoer10{
    .id = "gragg_bulirsch_stoer10",
    .source =
        "W. B. Gragg, SIAM J. Numer. Anal. 2 (1965) 384-403; E. Hairer, S. P. Norsett, G. Wanner, Solving "
        "ODEs I, II.9",
    .advice = "smooth problems at fixed steps beyond 1e-10, and long double; not for stiff or switching ones",
};
static_assert(gragg_bulirsch_stoer10.order == 10 && gragg_bulirsch_stoer10.embedded_order == 8);

}  // namespace odemark
