#pragma once
#include "integrators/fully_implicit_runge_kutta.hpp"

namespace odemark {

inline constexpr FullyImplicitRungeKutta<3> lobatto_iiib4{
    .id = "lobatto_iiib4",
    .source =
        "B. L. Ehle, On Pade approximations to the exponential function and A-stable methods, Univ. of "
        "Waterloo, research report CSRR 2010 (1969); E. Hairer, G. Wanner, Solving ODEs II (1996), IV.5, "
        "table 5.9",
    .order = 4,
    .jumps_over_poles = true,
    .a = {{{1.0L / 6, -1.0L / 6, 0}, {1.0L / 6, 1.0L / 3, 0}, {1.0L / 6, 5.0L / 6, 0}}},
    .b = {1.0L / 6, 2.0L / 3, 1.0L / 6},
    .note = "steps over a singularity: with fixed steps it returns as a finite number",
    .advice = "the partner of lobatto_iiia4 in symplectic pairs; alone it loses order where f is stiff",
};
static_assert(orders_hold(lobatto_iiib4));

}  // namespace odemark
