#pragma once
#include "integrators/methods/explicit_euler.hpp"
#include "integrators/step_doubling.hpp"

namespace odemark {

inline constexpr StepDoubling<explicit_euler> step_doubling_euler{
    .id = "step_doubling_euler",
    .source =
        "E. Hairer, S. P. Norsett, G. Wanner, Solving ODEs I, II.4 (the chapter's adaptive Euler done right)",
};

}  // namespace odemark
