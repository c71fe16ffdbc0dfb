#pragma once
#include "integrators/nystrom.hpp"
#include "integrators/nystrom_order.hpp"

namespace odemark {

inline constexpr Nystrom<6> rkn_dormand_prince64{
    .id = "rkn_dormand_prince64",
    .source =
        "J. R. Dormand, M. E. A. El-Mikkawy, P. J. Prince, IMA J. Numer. Anal. 7 (1987) 235-250, "
        "doi:10.1093/imanum/7.2.235 (RKN6(4)6FD)",
    .order = 6,
    .embedded_order = 4,
    .c = {0, 1.0L / 10, 3.0L / 10, 7.0L / 10, 17.0L / 25, 1},
    .a = {{{},
           {1.0L / 200},
           {-1.0L / 2200, 1.0L / 22},
           {637.0L / 6600, -7.0L / 110, 7.0L / 33},
           {225437.0L / 1968750, -30073.0L / 281250, 65569.0L / 281250, -9367.0L / 984375},
           {151.0L / 2142, 5.0L / 116, 385.0L / 1368, 55.0L / 168, -6250.0L / 28101}}},
    .b_position = {151.0L / 2142, 5.0L / 116, 385.0L / 1368, 55.0L / 168, -6250.0L / 28101, 0},
    .b_velocity = {151.0L / 2142, 25.0L / 522, 275.0L / 684, 275.0L / 252, -78125.0L / 112404, 1.0L / 12},
    .b_position_embedded = {1349.0L / 157500, 7873.0L / 50000, 192199.0L / 900000, 521683.0L / 2100000,
                            -16.0L / 125, 0},
    .b_velocity_embedded = {1349.0L / 157500, 7873.0L / 45000, 27457.0L / 90000, 521683.0L / 630000,
                            -2.0L / 5, 1.0L / 12},
    .advice =
        "orbits and other smooth forces without velocity at 1e-4 to 1e-9 with error control: five forces an "
        "accepted step; not for damped springs",
};
static_assert(orders_hold(rkn_dormand_prince64));

}  // namespace odemark
