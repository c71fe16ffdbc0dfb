#pragma once
#include "integrators/methods/adams_bashforth2.hpp"
#include "integrators/methods/heun.hpp"
#include "integrators/multistep.hpp"

namespace odemark {

/// Predictor of order 2, corrector of order 2, PECE.
inline constexpr PredictorCorrector<2, heun> adams_bashforth_moulton22{
    .id = "adams_bashforth_moulton22",
    .source =
        "E. Hairer, S. P. Norsett, G. Wanner, Solving ODEs I, III.1 and III.8; L. F. Shampine, M. K. Gordon, "
        "Computer Solution of Ordinary Differential Equations, 1975",
    .advice = "smooth problems at two evaluations per step; heun itself needs no history for the same price",
    .order = 2,
    .predictor = adams_bashforth2.formula,
    .corrector = {.next_slope = 1.0L / 2, .slopes = {1.0L / 2}},
};
static_assert(multistep_holds(adams_bashforth_moulton22));

}  // namespace odemark
