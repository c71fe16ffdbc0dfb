#pragma once
#include "integrators/fully_implicit_runge_kutta.hpp"

namespace odemark {

namespace detail {
inline constexpr StageVector<4> gauss8_nodes{
    0.0694318442029737123880267555535952475L, 0.330009478207571867598667120448377656L,
    0.669990521792428132401332879551622344L, 0.930568155797026287611973244446404753L};
}

inline constexpr FullyImplicitRungeKutta<4> gauss8{
    .id = "gauss8",
    .source =
        "J. C. Butcher, Math. Comp. 18 (1964) 50-64; E. Hairer, G. Wanner, Solving ODEs II (1996), IV.5, "
        "theorem 5.2 (zeros of the shifted Legendre polynomial of degree 4)",
    .order = 8,
    .jumps_over_poles = true,
    .a = collocation_matrix<4>(detail::gauss8_nodes),
    .b = quadrature_weights<4>(detail::gauss8_nodes),
    .note = "steps over a singularity: with fixed steps it returns as a finite number",
    .advice = "symplectic near round-off for smooth Hamiltonian problems; does not damp stiff springs",
};
static_assert(orders_hold(gauss8));

}  // namespace odemark
