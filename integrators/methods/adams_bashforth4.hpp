#pragma once
#include "integrators/methods/rk4.hpp"
#include "integrators/multistep.hpp"

namespace odemark {

inline constexpr ExplicitMultistep<4, rk4> adams_bashforth4{
    .id = "adams_bashforth4",
    .source = "E. Hairer, S. P. Norsett, G. Wanner, Solving ODEs I, III.1, table 1.1",
    .advice =
        "smooth problems with a costly right-hand side and a fixed step; not near its limit of 0.3 on the "
        "real axis",
    .order = 4,
    .formula = {.slopes = {55.0L / 24, -59.0L / 24, 37.0L / 24, -9.0L / 24}},
};
static_assert(multistep_holds(adams_bashforth4));

}  // namespace odemark
