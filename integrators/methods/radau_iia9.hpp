#pragma once
#include "integrators/fully_implicit_runge_kutta.hpp"

namespace odemark {

namespace detail {
inline constexpr StageVector<5> radau_iia9_nodes{
    0.0571041961145176821931211925541156212L, 0.276843013638123827680045997685625141L,
    0.583590432368916820056697668662917249L, 0.860240135656219447847912918875119767L, 1};
}

inline constexpr FullyImplicitRungeKutta<5> radau_iia9{
    .id = "radau_iia9",
    .source =
        "E. Hairer, G. Wanner, J. Comput. Appl. Math. 111 (1999) 93-111; Solving ODEs II (1996), IV.5, "
        "theorem 5.5",
    .order = 9,
    .embedded_order = 5,
    .a = collocation_matrix<5>(detail::radau_iia9_nodes),
    .b = quadrature_weights<5>(detail::radau_iia9_nodes),
    .advice = "stiff problems at 1e-9 to 1e-12; too dear below",
};
static_assert(orders_hold(radau_iia9));

}  // namespace odemark
