#pragma once
#include "integrators/splitting_order.hpp"

namespace odemark {

inline constexpr Splitting<4> ruth3{
    .id = "ruth3",
    .source =
        "R. D. Ruth, IEEE Trans. Nucl. Sci. 30 (1983) 2669-2671, doi:10.1109/TNS.1983.4332919 (kick first)",
    .order = 3,
    .drift = {0, 2.0L / 3, -2.0L / 3, 1},
    .kick = {7.0L / 24, 3.0L / 4, -1.0L / 24, 0},
    .note = "order 1 where the force depends on velocity",
    .advice = "historical: mclachlan_atela3 costs the same and errs less",
};
static_assert(orders_hold(ruth3));

}  // namespace odemark
