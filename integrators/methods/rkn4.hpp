#pragma once
#include "integrators/nystrom.hpp"
#include "integrators/nystrom_order.hpp"

namespace odemark {

inline constexpr Nystrom<3> rkn4{
    .id = "rkn4",
    .source =
        "E. J. Nystrom, Acta Soc. Sci. Fenn. 50 (1925) no. 13; E. Hairer, S. P. Norsett, G. Wanner, Solving "
        "ODEs I, II.14, table 14.2 (x'' = f(t, x))",
    .order = 4,
    .c = {0, 1.0L / 2, 1},
    .a = {{{}, {1.0L / 8}, {0, 1.0L / 2}}},
    .b_position = {1.0L / 6, 1.0L / 3, 0},
    .b_velocity = {1.0L / 6, 4.0L / 6, 1.0L / 6},
    .advice =
        "order 4 for three forces a step where force does not depend on velocity: cheaper than rk4; over "
        "long times use pefrl",
};
static_assert(orders_hold(rkn4));

}  // namespace odemark
