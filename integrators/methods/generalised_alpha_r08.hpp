#pragma once
#include "integrators/generalised_alpha.hpp"

namespace odemark {

/// r is the spectral radius of infinite steps: alpha_m = (2 r - 1)/(r + 1), alpha_f = r/(r + 1), beta = (1 -
/// alpha_m
/// + alpha_f)^2 / 4, gamma = 1/2 - alpha_m + alpha_f, with r = 8/10.
inline constexpr GeneralisedAlpha generalised_alpha_r08{
    .id = "generalised_alpha_r08",
    .source = "J. Chung, G. M. Hulbert, J. Appl. Mech. 60 (1993) 371-375, doi:10.1115/1.2900803",
    .alpha_m = 1.0L / 3,
    .alpha_f = 4.0L / 9,
    .beta = 25.0L / 81,
    .gamma = 11.0L / 18,
    .starter = "the force at the start",
    .note = "a force that is not linear is taken at the blended state, not blended itself",
    .advice =
        "structures and flexible bodies at any dt, stiff modes lose a fifth a step; not where energy must be "
        "kept",
};
static_assert(generalised_alpha_r08.second_order_and_stable() && generalised_alpha_r08.says_how_it_starts());

}  // namespace odemark
