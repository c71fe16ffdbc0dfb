#pragma once
#include "integrators/methods/adams_bashforth4.hpp"
#include "integrators/methods/adams_moulton4.hpp"
#include "integrators/methods/rk4.hpp"
#include "integrators/multistep.hpp"

namespace odemark {

/// Predictor of order 4, corrector of order 4, PECE.
inline constexpr PredictorCorrector<4, rk4> adams_bashforth_moulton44{
    .id = "adams_bashforth_moulton44",
    .source =
        "E. Hairer, S. P. Norsett, G. Wanner, Solving ODEs I, III.1 and III.8; L. F. Shampine, M. K. Gordon, "
        "Computer Solution of Ordinary Differential Equations, 1975",
    .advice =
        "the textbook pair of order 4: half the evaluations of rk4 per step at less than half its limit; not "
        "for stiff problems",
    .order = 4,
    .predictor = adams_bashforth4.formula,
    .corrector = widened<4>(adams_moulton4.formula),
};
static_assert(multistep_holds(adams_bashforth_moulton44));

}  // namespace odemark
