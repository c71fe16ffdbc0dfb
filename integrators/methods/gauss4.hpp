#pragma once
#include "integrators/fully_implicit_runge_kutta.hpp"

namespace odemark {

namespace detail {
inline constexpr Coefficient sqrt3 = 1.73205080756887729352744634150587237L;
}

inline constexpr FullyImplicitRungeKutta<2> gauss4{
    .id = "gauss4",
    .source =
        "J. C. Butcher, Math. Comp. 18 (1964) 50-64; E. Hairer, G. Wanner, Solving ODEs II (1996), IV.5, "
        "table 5.1",
    .order = 4,
    .jumps_over_poles = true,
    .a = {{{1.0L / 4, 1.0L / 4 - detail::sqrt3 / 6}, {1.0L / 4 + detail::sqrt3 / 6, 1.0L / 4}}},
    .b = {1.0L / 2, 1.0L / 2},
    .note = "steps over a singularity: with fixed steps it returns as a finite number",
    .advice = "symplectic and symmetric for long Hamiltonian runs, stiff or not; does not damp stiff springs",
};
static_assert(orders_hold(gauss4));

}  // namespace odemark
