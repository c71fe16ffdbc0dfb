#pragma once
#include "integrators/adams_bashforth.hpp"
#include "integrators/methods/bogacki_shampine32.hpp"

namespace odemark {

inline constexpr AdamsBashforth<3, bogacki_shampine32> adams_bashforth3{
    .id = "adams_bashforth3",
    .source = "E. Hairer, S. P. Norsett, G. Wanner, Solving ODEs I, III.1, table 1.1",
    .order = 3,
    .weights = {23.0L / 12, -16.0L / 12, 5.0L / 12},
};
static_assert(adams_order_holds(adams_bashforth3) && bogacki_shampine32.order >= adams_bashforth3.order);

}  // namespace odemark
