#include "reference/truth_run.hpp"

#include <algorithm>

#include "integrators/bracket_root.hpp"

namespace odemark {

namespace {

constexpr std::size_t most_events = 100'000;

/// Finds what the state decides, on the way of a solver.
class EventWatch {
 public:
  EventWatch(TruthSolver& solver, const WideProblem& problem)
      : solver_(solver),
        problem_(problem),
        armed_(problem.events.count, false),
        left_value_(problem.events.count),
        value_(problem.events.count) {}

  bool idle() const { return armed_.empty(); }
  void begin(const Wide& t, const std::vector<Wide>& y, std::size_t phase) {
    left_t_ = t, left_ = y;
    values(t, y, phase, left_value_);
    for (std::size_t k = 0; k < armed_.size(); ++k) armed_[k] = left_value_[k] > 0;
  }
  /// The solver has come from the last place to (t, y). True where a jump lies in between: then t, y and the
  /// phase are what it leaves behind, and the solver must enter again.
  bool passed(Wide& t, std::vector<Wide>& y, std::size_t& phase, RunBudget& budget) {
    values(t, y, phase, value_);
    Wide first = t;
    std::vector<Wide> there = y;
    std::size_t which = armed_.size();
    for (std::size_t k = 0; k < armed_.size(); ++k)
      if (armed_[k] && value_[k] <= 0) {
        Wide at = first;
        std::vector<Wide> state = there;
        locate(k, phase, at, state, budget);
        if (which == armed_.size() || at < first) first = at, there = state, which = k;
      }
    if (which == armed_.size()) {
      begin(t, y, phase);
      return false;
    }
    if (events.size() >= most_events) throw RunFailed("more events than can be meant");
    if (!problem_.events.jumps) {
      events.push_back({which, phase, first});
      solver_.enter({&problem_, &problem_.phases[phase]});
      begin(t, y, phase);
      return false;
    }
    t = first, y = there;
    phase = problem_.events.after(problem_.phases[phase].value.get(), which, t, y.data(), phase);
    events.push_back({which, phase, t});
    begin(t, y, phase);
    for (std::size_t k = 0; k < armed_.size(); ++k) armed_[k] = left_value_[k] >= 0;
    return true;
  }

  std::vector<WideEvent> events;

 private:
  void values(const Wide& t, const std::vector<Wide>& y, std::size_t phase, std::vector<Wide>& g) const {
    if (!idle()) problem_.events.values(problem_.phases[phase].value.get(), t, y.data(), g.data());
  }
  Wide value_at(std::size_t k, std::size_t phase, const Wide& t, std::vector<Wide>& y, RunBudget& budget) {
    y = left_;
    Wide now = left_t_;
    solver_.enter({&problem_, &problem_.phases[phase]});
    solver_.advance(now, y, t, budget);
    std::vector<Wide> g(armed_.size());
    values(t, y, phase, g);
    return g[k];
  }
  /// The first event k between the last place and (t, y), which is behind it.
  void locate(std::size_t k, std::size_t phase, Wide& t, std::vector<Wide>& y, RunBudget& budget) {
    Wide before = left_t_, above = left_value_[k], below = value_[k];
    std::vector<Wide> trial;
    const auto at = [&](const Wide& wished) {
      const Wide g = value_at(k, phase, wished, trial, budget);
      if (!(g > 0)) t = wished, y = trial, below = g;
      return g;
    };
    const Wide width = Wide("1e-48") * (abs(t) + problem_.events.look_every);
    while (!(above > 0) && t - left_t_ > width) {
      const Wide middle = left_t_ + (t - left_t_) / 2, g = at(middle);
      if (g > 0) before = middle, above = g;
    }
    if (above > 0) bracket_root(before, above, Wide(t), Wide(below), width, at);
  }

  TruthSolver& solver_;
  const WideProblem& problem_;
  std::vector<bool> armed_;
  Wide left_t_ = 0;
  std::vector<Wide> left_, left_value_, value_;
};

}  // namespace

WideRun run(TruthSolver& solver, const WideProblem& problem, std::vector<Wide> start,
            const std::vector<Wide>& times, const std::vector<Wide>& stops, RunBudget& budget,
            double look_share) {
  WideRun out;
  std::vector<Wide> y = std::move(start);
  Wide t = 0;
  std::size_t phase = 0;
  const auto& switches = problem.switch_times;
  const Wide look_every = problem.events.look_every * Wide(look_share);
  EventWatch watch(solver, problem);
  const auto enter_phase = [&] {
    while (phase < switches.size() && switches[phase] <= t) ++phase;
    solver.enter({&problem, &problem.phases[phase]});
    watch.begin(t, y, phase);
  };
  enter_phase();
  for (const Wide& time : times) {
    while (t < time) {
      Wide stop = time;
      if (!watch.idle() && t + look_every < stop) stop = t + look_every;
      for (const Wide& s : stops)
        if (s > t && s < stop) stop = s;
      const bool switching = phase < switches.size() && switches[phase] <= stop;
      if (switching) stop = switches[phase];
      solver.advance(t, y, stop, budget);
      if (!watch.idle() && watch.passed(t, y, phase, budget))
        solver.enter({&problem, &problem.phases[phase]});
      else if (switching)
        enter_phase();
    }
    for (const Wide& value : y)
      if (!isfinite(value)) throw RunFailed("the solution is not finite at t = " + t.str(8));
    out.states.push_back(y);
  }
  out.events = std::move(watch.events);
  return out;
}

WideRun run_closed_form(const WideProblem& problem, const std::vector<Wide>& start,
                        const std::vector<Wide>& times) {
  WideRun out;
  for (const Wide& t : times) {
    std::vector<Wide> y(problem.size);
    problem.exact(problem.value.get(), t, start.data(), y.data());
    for (const Wide& value : y)
      if (!isfinite(value)) throw RunFailed("the closed form is not finite at t = " + t.str(8));
    out.states.push_back(std::move(y));
  }
  if (problem.exact_events) problem.exact_events(problem.value.get(), times.back(), start.data(), out.events);
  return out;
}

}  // namespace odemark
