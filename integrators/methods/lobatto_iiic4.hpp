#pragma once
#include "integrators/fully_implicit_runge_kutta.hpp"

namespace odemark {

inline constexpr FullyImplicitRungeKutta<3> lobatto_iiic4{
    .id = "lobatto_iiic4",
    .source =
        "F. H. Chipman, BIT 11 (1971) 384-388; E. Hairer, G. Wanner, Solving ODEs II (1996), IV.5, table "
        "5.11",
    .order = 4,
    .jumps_over_poles = true,
    .a = {{{1.0L / 6, -1.0L / 3, 1.0L / 6},
           {1.0L / 6, 5.0L / 12, -1.0L / 12},
           {1.0L / 6, 2.0L / 3, 1.0L / 6}}},
    .b = {1.0L / 6, 2.0L / 3, 1.0L / 6},
    .note = "steps over a singularity: with fixed steps it returns as a finite number",
    .advice =
        "L-stable and algebraically stable, fixed steps over strong damping; radau_iia5 has one order more",
};
static_assert(orders_hold(lobatto_iiic4));

}  // namespace odemark
