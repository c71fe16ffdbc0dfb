#pragma once
#include "integrators/exponential.hpp"

namespace odemark {

inline constexpr ExponentialRungeKutta<2> etd2rk{
    .id = "etd2rk",
    .source = "S. M. Cox, P. C. Matthews, J. Comput. Phys. 176 (2002) 430-455, eq. 22",
    .advice = "a stiff linear part and a smooth rest at 1e-2 to 1e-4, two evaluations a step",
    .order = 2,
    .c = {0, 1},
    .b = {{{}, phi(2)}},
};
static_assert(orders_hold(etd2rk));

}  // namespace odemark
