// One computation of a solution at given times, from switch to switch.
#pragma once

#include "reference/truth_solver.hpp"

namespace odemark {

using WideTrajectory = std::vector<std::vector<Wide>>;  // a state for each time

struct WideRun {
  WideTrajectory states;
  std::vector<WideEvent> events;
};

/// States at `times` (ascending, positive) from `start` at t = 0. Steps end on every time, every switch and
/// every one of `stops`: instants that another solver found to be kinks. The right-hand side stays the true
/// one, so that a misplaced stop can only make two computations disagree. Events are looked for every
/// `look_share` of the problem's own interval for it and found to the last digits; kinks are only noted. At
/// the instant of an event the state is the one after it. Throws RunFailed.
WideRun run(TruthSolver& solver, const WideProblem& problem, std::vector<Wide> start,
            const std::vector<Wide>& times, const std::vector<Wide>& stops, RunBudget& budget,
            double look_share = 1);

/// The closed form at `times`.
WideRun run_closed_form(const WideProblem& problem, const std::vector<Wide>& start,
                        const std::vector<Wide>& times);

}  // namespace odemark
