#pragma once
#include "integrators/methods/rk4.hpp"
#include "integrators/multistep.hpp"

namespace odemark {

inline constexpr ExplicitMultistep<4, rk4> nystrom_multistep4{
    .id = "nystrom_multistep4",
    .source =
        "E. J. Nystrom, Acta Soc. Sci. Fenn. 50, 13 (1925) 1-55; E. Hairer, S. P. Norsett, G. Wanner, "
        "Solving ODEs I, III.1",
    .advice = "to show weak instability: accurate on short runs, unstable on every decaying problem",
    .order = 4,
    .formula = {.states = {0, 1}, .slopes = {8.0L / 3, -5.0L / 3, 4.0L / 3, -1.0L / 3}},
};
static_assert(multistep_holds(nystrom_multistep4));

}  // namespace odemark
