#pragma once
#include "integrators/nystrom.hpp"
#include "integrators/nystrom_order.hpp"

namespace odemark {

inline constexpr Nystrom<4> rkn5{
    .id = "rkn5",
    .source =
        "E. J. Nystrom, Acta Soc. Sci. Fenn. 50 (1925) no. 13; E. Hairer, S. P. Norsett, G. Wanner, Solving "
        "ODEs I, II.14, table 14.2 (x'' = f(t, x))",
    .order = 5,
    .c = {0, 1.0L / 5, 2.0L / 3, 1},
    .a = {{{}, {1.0L / 50}, {-1.0L / 27, 7.0L / 27}, {3.0L / 10, -2.0L / 35, 9.0L / 35}}},
    .b_position = {14.0L / 336, 100.0L / 336, 54.0L / 336, 0},
    .b_velocity = {14.0L / 336, 125.0L / 336, 162.0L / 336, 35.0L / 336},
    .advice =
        "order 5 for four forces a step where force does not depend on velocity; with error control use "
        "rkn_dormand_prince64",
};
static_assert(orders_hold(rkn5));

}  // namespace odemark
