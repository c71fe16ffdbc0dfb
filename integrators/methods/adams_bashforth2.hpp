#pragma once
#include "integrators/adams_bashforth.hpp"
#include "integrators/methods/heun.hpp"

namespace odemark {

inline constexpr AdamsBashforth<2, heun> adams_bashforth2{
    .id = "adams_bashforth2",
    .source = "E. Hairer, S. P. Norsett, G. Wanner, Solving ODEs I, III.1, table 1.1",
    .order = 2,
    .weights = {3.0L / 2, -1.0L / 2},
};
static_assert(adams_order_holds(adams_bashforth2) && heun.order >= adams_bashforth2.order);

}  // namespace odemark
