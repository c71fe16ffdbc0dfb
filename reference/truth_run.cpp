#include "reference/truth_run.hpp"

#include <algorithm>

namespace odemark {

WideTrajectory run(TruthSolver& solver, const WideProblem& problem, std::vector<Wide> start,
                   const std::vector<Wide>& times, const std::vector<Wide>& stops, RunBudget& budget) {
  WideTrajectory states;
  std::vector<Wide> y = std::move(start);
  Wide t = 0;
  std::size_t phase = 0;
  const auto& switches = problem.switch_times;
  const auto enter_phase = [&] {
    while (phase < switches.size() && switches[phase] <= t) ++phase;
    solver.enter({&problem, &problem.phases[phase]});
  };
  enter_phase();
  for (const Wide& time : times) {
    while (t < time) {
      Wide stop = time;
      for (const Wide& s : stops)
        if (s > t && s < stop) stop = s;
      const bool switching = phase < switches.size() && switches[phase] <= stop;
      if (switching) stop = switches[phase];
      solver.advance(t, y, stop, budget);
      if (switching) enter_phase();
    }
    for (const Wide& value : y)
      if (!isfinite(value)) throw RunFailed("the solution is not finite at t = " + t.str(8));
    states.push_back(y);
  }
  return states;
}

WideTrajectory run_closed_form(const WideProblem& problem, const std::vector<Wide>& start,
                               const std::vector<Wide>& times) {
  WideTrajectory states;
  for (const Wide& t : times) {
    std::vector<Wide> y(problem.size);
    problem.exact(problem.value.get(), t, start.data(), y.data());
    for (const Wide& value : y)
      if (!isfinite(value)) throw RunFailed("the closed form is not finite at t = " + t.str(8));
    states.push_back(std::move(y));
  }
  return states;
}

}  // namespace odemark
