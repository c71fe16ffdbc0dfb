#pragma once
#include "integrators/fully_implicit_runge_kutta.hpp"

namespace odemark {

namespace detail {
inline constexpr StageVector<7> radau_iia13_nodes{0.0293164271597848919720502769131649104L,
                                                  0.148078599668484291849976852495979212L,
                                                  0.336984690281154299097052972080775705L,
                                                  0.55867151877155013208139334180552194L,
                                                  0.769233862030054500916883360115645452L,
                                                  0.926945671319741114851873965819682011L,
                                                  1};
}

inline constexpr FullyImplicitRungeKutta<7> radau_iia13{
    .id = "radau_iia13",
    .source =
        "E. Hairer, G. Wanner, J. Comput. Appl. Math. 111 (1999) 93-111; Solving ODEs II (1996), IV.5, "
        "theorem 5.5",
    .order = 13,
    .embedded_order = 7,
    .a = collocation_matrix<7>(detail::radau_iia13_nodes),
    .b = quadrature_weights<7>(detail::radau_iia13_nodes),
    .advice = "stiff problems at 1e-12 and beyond; too dear below",
};
static_assert(orders_hold(radau_iia13));

}  // namespace odemark
