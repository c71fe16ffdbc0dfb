#pragma once
#include "integrators/methods/bogacki_shampine32.hpp"
#include "integrators/multistep.hpp"

namespace odemark {

inline constexpr ExplicitMultistep<3, bogacki_shampine32> nystrom_multistep3{
    .id = "nystrom_multistep3",
    .source =
        "E. J. Nystrom, Acta Soc. Sci. Fenn. 50, 13 (1925) 1-55; E. Hairer, S. P. Norsett, G. Wanner, "
        "Solving ODEs I, III.1",
    .advice = "to show weak instability: accurate on short runs, unstable on every decaying problem",
    .order = 3,
    .formula = {.states = {0, 1}, .slopes = {7.0L / 3, -2.0L / 3, 1.0L / 3}},
};
static_assert(multistep_holds(nystrom_multistep3));

}  // namespace odemark
