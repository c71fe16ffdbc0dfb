#pragma once
#include "integrators/extrapolation.hpp"

namespace odemark {

inline constexpr VariableExtrapolation<GraggRule> gragg_bulirsch_stoer{
    .id = "gragg_bulirsch_stoer",
    .source =
        "R. Bulirsch, J. Stoer, Numer. Math. 8 (1966) 1-13; P. Deuflhard, Numer. Math. 41 (1983) 399-422; "
        "E. Hairer, S. P. Norsett, G. Wanner, Solving ODEs I, II.9",
    .advice =
        "smooth problems at 1e-9 and below, and in long double; not for stiff problems or forces that switch",
};

}  // namespace odemark
