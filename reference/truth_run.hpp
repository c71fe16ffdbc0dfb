// One computation of a solution at given times, from switch to switch.
#pragma once

#include "reference/truth_solver.hpp"

namespace odemark {

using WideTrajectory = std::vector<std::vector<Wide>>;  // a state for each time

/// States at `times` (ascending, positive) from `start` at t = 0. Steps end on every time, every switch and
/// every one of `stops`: instants that another solver found to be kinks. The right-hand side stays the true
/// one, so that a misplaced stop can only make two computations disagree. Throws RunFailed.
WideTrajectory run(TruthSolver& solver, const WideProblem& problem, std::vector<Wide> start,
                   const std::vector<Wide>& times, const std::vector<Wide>& stops, RunBudget& budget);

/// The closed form at `times`.
WideTrajectory run_closed_form(const WideProblem& problem, const std::vector<Wide>& start,
                               const std::vector<Wide>& times);

}  // namespace odemark
