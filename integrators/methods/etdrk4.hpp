#pragma once
#include "integrators/exponential.hpp"

namespace odemark {

inline constexpr ExponentialRungeKutta<4> etdrk4{
    .id = "etdrk4",
    .source =
        "S. M. Cox, P. C. Matthews, J. Comput. Phys. 176 (2002) 430-455, eqs. 26-29; phi-form in M. "
        "Hochbruck, A. Ostermann, "
        "Acta Numerica 19 (2010) 209-286, eq. 2.41",
    .advice = "a stiff linear part and a smooth rest at 1e-4 and below with a constant dt",
    .order = 4,
    .c = {0, 1.0L / 2, 1.0L / 2, 1},
    .a = {{{}, {}, {{{}, 0.5L * phi(1, 0.5L)}}, {{{}, {}, phi(1, 0.5L)}}}},
    .b = {{{}, 2 * phi(2) - 4 * phi(3), 2 * phi(2) - 4 * phi(3), 4 * phi(3) - phi(2)}},
};
static_assert(orders_hold(etdrk4));

}  // namespace odemark
