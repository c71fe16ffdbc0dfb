#pragma once
#include "integrators/methods/rk4.hpp"
#include "integrators/multistep.hpp"

namespace odemark {

/// Milne's method: predicted over four steps, corrected once by Simpson's rule (PECE).
inline constexpr PredictorCorrector<4, rk4> milne_simpson4{
    .id = "milne_simpson4",
    .source =
        "W. E. Milne, Amer. Math. Monthly 33 (1926) 455-460; E. Hairer, S. P. Norsett, G. Wanner, Solving "
        "ODEs I, III.1",
    .advice =
        "short, smooth runs with a costly right-hand side; unstable for small steps on every decaying "
        "problem",
    .order = 4,
    .predictor = {.states = {0, 0, 0, 1}, .slopes = {8.0L / 3, -4.0L / 3, 8.0L / 3}},
    .corrector = {.states = {0, 1}, .next_slope = 1.0L / 3, .slopes = {4.0L / 3, 1.0L / 3}},
};
static_assert(multistep_holds(milne_simpson4));

}  // namespace odemark
