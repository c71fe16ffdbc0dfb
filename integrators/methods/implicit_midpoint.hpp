#pragma once
#include "integrators/diagonally_implicit_runge_kutta.hpp"
#include "integrators/order_conditions.hpp"

namespace odemark {

inline constexpr DiagonallyImplicitRungeKutta<1> implicit_midpoint{
    .id = "implicit_midpoint",
    .source = "E. Hairer, G. Wanner, Solving ODEs II, IV.3 (Gauss, one stage)",
    .order = 2,
    .a = {{{1.0L / 2}}},
    .b = {1},
    .advice = "long Hamiltonian runs with large steps, symplectic; stiff springs ring on undamped",
};
static_assert(orders_hold(implicit_midpoint));

}  // namespace odemark
