#pragma once
#include "integrators/methods/adams_bashforth5.hpp"
#include "integrators/methods/adams_moulton5.hpp"
#include "integrators/methods/dormand_prince54.hpp"
#include "integrators/multistep.hpp"

namespace odemark {

/// Predictor of order 5, corrector of order 5, PECE.
inline constexpr PredictorCorrector<5, dormand_prince54> adams_bashforth_moulton55{
    .id = "adams_bashforth_moulton55",
    .source =
        "E. Hairer, S. P. Norsett, G. Wanner, Solving ODEs I, III.1 and III.8; L. F. Shampine, M. K. Gordon, "
        "Computer Solution of Ordinary Differential Equations, 1975",
    .advice = "smooth problems with a costly right-hand side at small fixed steps; not for stiff ones",
    .order = 5,
    .predictor = adams_bashforth5.formula,
    .corrector = widened<5>(adams_moulton5.formula),
};
static_assert(multistep_holds(adams_bashforth_moulton55));

}  // namespace odemark
