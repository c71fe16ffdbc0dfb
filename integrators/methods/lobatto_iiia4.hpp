#pragma once
#include "integrators/fully_implicit_runge_kutta.hpp"

namespace odemark {

inline constexpr FullyImplicitRungeKutta<3> lobatto_iiia4{
    .id = "lobatto_iiia4",
    .source =
        "B. L. Ehle, On Pade approximations to the exponential function and A-stable methods, Univ. of "
        "Waterloo, research report CSRR 2010 (1969); E. Hairer, G. Wanner, Solving ODEs II (1996), IV.5, "
        "table 5.7",
    .order = 4,
    .a = {{{}, {5.0L / 24, 1.0L / 3, -1.0L / 24}, {1.0L / 6, 2.0L / 3, 1.0L / 6}}},
    .b = {1.0L / 6, 2.0L / 3, 1.0L / 6},
    .advice =
        "symmetric, order 4 with a free first stage; boundary value problems; does not damp stiff springs",
};
static_assert(orders_hold(lobatto_iiia4));

}  // namespace odemark
