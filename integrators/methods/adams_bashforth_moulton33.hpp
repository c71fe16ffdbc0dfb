#pragma once
#include "integrators/methods/adams_bashforth3.hpp"
#include "integrators/methods/adams_moulton3.hpp"
#include "integrators/methods/bogacki_shampine32.hpp"
#include "integrators/multistep.hpp"

namespace odemark {

/// Predictor of order 3, corrector of order 3, PECE.
inline constexpr PredictorCorrector<3, bogacki_shampine32> adams_bashforth_moulton33{
    .id = "adams_bashforth_moulton33",
    .source =
        "E. Hairer, S. P. Norsett, G. Wanner, Solving ODEs I, III.1 and III.8; L. F. Shampine, M. K. Gordon, "
        "Computer Solution of Ordinary Differential Equations, 1975",
    .advice =
        "predictor and corrector of three steps and order 3; take adams_bashforth_moulton34 for one order "
        "more at the same price",
    .order = 3,
    .predictor = adams_bashforth3.formula,
    .corrector = widened<3>(adams_moulton3.formula),
};
static_assert(multistep_holds(adams_bashforth_moulton33));

}  // namespace odemark
