#pragma once
#include "integrators/generalised_alpha.hpp"

namespace odemark {

inline constexpr GeneralisedAlpha newmark_beta{
    .id = "newmark_beta",
    .source =
        "N. M. Newmark, J. Eng. Mech. Div. ASCE 85 (EM3, 1959) 67-94 (average acceleration: beta = 1/4, "
        "gamma = "
        "1/2)",
    .advice =
        "structures at any dt without losing energy; not where stiff modes must die out: they ring for ever",
};
static_assert(newmark_beta.second_order_and_stable() && newmark_beta.says_how_it_starts());

}  // namespace odemark
