#pragma once
#include "integrators/exponential.hpp"

namespace odemark {

inline constexpr ExponentialRungeKutta<4> krogstad4{
    .id = "krogstad4",
    .source =
        "S. Krogstad, J. Comput. Phys. 203 (2005) 72-88 (ETDRK4-B); phi-form in M. Hochbruck, A. Ostermann, "
        "Acta Numerica 19 "
        "(2010) 209-286, eq. 2.42",
    .advice = "as etdrk4, with a smaller error on semi-discretised equations",
    .order = 4,
    .c = {0, 1.0L / 2, 1.0L / 2, 1},
    .a = {{{}, {}, {{{}, phi(2, 0.5L)}}, {{{}, {}, 2 * phi(2)}}}},
    .b = {{{}, 2 * phi(2) - 4 * phi(3), 2 * phi(2) - 4 * phi(3), 4 * phi(3) - phi(2)}},
};
static_assert(orders_hold(krogstad4));

}  // namespace odemark
