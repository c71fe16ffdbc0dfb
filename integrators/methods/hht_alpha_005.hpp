#pragma once
#include "integrators/generalised_alpha.hpp"

namespace odemark {

/// Their alpha is -alpha_f; beta = (1 - alpha)^2 / 4 and gamma = 1/2 - alpha.
inline constexpr GeneralisedAlpha hht_alpha_005{
    .id = "hht_alpha_005",
    .source =
        "H. M. Hilber, T. J. R. Hughes, R. L. Taylor, Earthq. Eng. Struct. Dyn. 5 (1977) 283-292, "
        "doi:10.1002/eqe.4290050306 (alpha = -0.05)",
    .alpha_f = 0.05L,
    .beta = 1.05L * 1.05L / 4,
    .gamma = 0.55L,
    .starter = "the force at the start",
    .note = "a force that is not linear is taken at the blended state, not blended itself",
    .advice =
        "structural codes' default: stiff modes fade slowly, the rest keeps order 2; not for steep nonlinear "
        "forces",
};
static_assert(hht_alpha_005.second_order_and_stable() && hht_alpha_005.says_how_it_starts());

}  // namespace odemark
