#pragma once
#include "integrators/methods/adams_bashforth3.hpp"
#include "integrators/methods/adams_moulton4.hpp"
#include "integrators/methods/rk4.hpp"
#include "integrators/multistep.hpp"

namespace odemark {

/// Predictor of order 3, corrector of order 4, PECE.
inline constexpr PredictorCorrector<3, rk4> adams_bashforth_moulton34{
    .id = "adams_bashforth_moulton34",
    .source =
        "E. Hairer, S. P. Norsett, G. Wanner, Solving ODEs I, III.1 and III.8; L. F. Shampine, M. K. Gordon, "
        "Computer Solution of Ordinary Differential Equations, 1975",
    .advice =
        "the three-step pair of order 4: smooth problems at two evaluations per step; not for stiff ones",
    .order = 4,
    .predictor = adams_bashforth3.formula,
    .corrector = adams_moulton4.formula,
};
static_assert(multistep_holds(adams_bashforth_moulton34));

}  // namespace odemark
