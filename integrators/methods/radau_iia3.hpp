#pragma once
#include "integrators/fully_implicit_runge_kutta.hpp"

namespace odemark {

inline constexpr FullyImplicitRungeKutta<2> radau_iia3{
    .id = "radau_iia3",
    .source =
        "O. Axelsson, BIT 9 (1969) 185-199, doi:10.1007/BF01946812; B. L. Ehle, SIAM J. Math. Anal. 4 "
        "(1973) 671-680; E. Hairer, G. Wanner, Solving ODEs II (1996), IV.5, table 5.5",
    .order = 3,
    .a = {{{5.0L / 12, -1.0L / 12}, {3.0L / 4, 1.0L / 4}}},
    .b = {3.0L / 4, 1.0L / 4},
    .advice = "robust fixed steps on stiff springs, damps what it cannot resolve; no error control",
};
static_assert(orders_hold(radau_iia3));

}  // namespace odemark
