// Claim 7: the chapter's adaptive listing beside a correct step-doubling controller, step by step.
#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "bench/chapter_lab.hpp"

namespace odemark::chapter {

namespace {

using Wide = std::vector<long double>;

/// Moves y along the exact flow from t to t + h.
void advance(const AnyProblem& problem, double t, double h, Wide& y) {
  y = exact_flow<long double>(problem, static_cast<long double>(h), y, static_cast<long double>(t));
}

/// |V1 - V2| as the listing forms it: only the speed takes the half step.
double listing_estimate(const AnyProblem& problem, double t, double h, const std::vector<double>& y) {
  const ErasedSystem<double>& system = problem.system<double>();
  const std::size_t half = y.size() / 2;
  std::vector<double> middle = y, a(y.size()), b(y.size());
  system.acceleration(t, y, a.data());
  for (std::size_t i = 0; i < half; ++i) middle[half + i] += a[i] * (h / 2);
  system.acceleration(t + h / 2, middle, b.data());
  double worst = 0;
  for (std::size_t i = 0; i < half; ++i) {
    const double v1 = y[half + i] + a[i] * h, v2 = middle[half + i] + b[i] * (h / 2);
    worst = std::max(worst, std::abs(v1 - v2));
  }
  return worst;
}

double energy_of(const AnyProblem& problem, const std::vector<double>& y) {
  Wide wide(y.begin(), y.end()), invariants(problem.invariant_names.size());
  problem.invariants_call(problem.value.get(), wide.data(), invariants.data());
  return double(invariants.front());
}

struct Asked {
  const char* method;
  double tolerance, nominal, t_end;
};

AdaptiveRun adaptive_run(const AnyProblem& problem, const Asked& asked) {
  AdaptiveRun run{problem.id, asked.method, asked.tolerance, asked.nominal, asked.t_end};
  const std::size_t half = problem.size() / 2;
  const long nominal_steps = std::lround(asked.t_end / asked.nominal);
  std::vector<double> old = problem.initial;
  Wide truth(old.begin(), old.end());
  double t_old = 0;
  long over = 0, zeros = 0;
  const double negligible = 16 * std::numeric_limits<double>::epsilon() * problem.scale[half];
  run.smallest_dt = std::numeric_limits<double>::infinity();
  const auto look = [&](double t, const double* y) {
    const double h = t - t_old;
    Wide local(old.begin(), old.end());
    advance(problem, t_old, h, local);
    advance(problem, t_old, h, truth);
    double error = 0;
    for (std::size_t i = 0; i < half; ++i) {
      error = std::max(error, double(std::abs(static_cast<long double>(y[half + i]) - local[half + i])));
      run.worst_position =
          std::max(run.worst_position, double(std::abs(static_cast<long double>(y[i]) - local[i])));
      run.global_error = std::max(
          run.global_error,
          double(std::abs(static_cast<long double>(y[half + i]) - truth[half + i])) / asked.tolerance);
    }
    const double estimate = listing_estimate(problem, t_old, h, old);
    run.worst_estimate = std::max(run.worst_estimate, estimate / asked.tolerance);
    run.worst_local = std::max(run.worst_local, error / asked.tolerance);
    over += error > asked.tolerance, zeros += estimate <= negligible;
    run.t.push_back(t_old), run.local.push_back(error / asked.tolerance);
    if (t < asked.t_end) run.smallest_dt = std::min(run.smallest_dt, h);  // the last step may be cut short
    run.largest_dt = std::max(run.largest_dt, h);
    if (long(run.t.size()) == nominal_steps) run.clock_lag = asked.t_end - t;
    t_old = t, old.assign(y, y + problem.size());
    return true;
  };
  ErrorControl control{0, asked.tolerance};
  if (asked.method == std::string_view("step_doubling_euler")) {
    // the norm is a root mean square in units of the scale: no component alone may exceed the tolerance
    control.absolute_tolerance /= problem.scale[half] * std::sqrt(double(problem.size()));
    control.scale = problem.scale.data();
  }
  control.first_step = asked.nominal;
  const auto out = adapt<double>(method_called(asked.method), problem, control, asked.t_end, look);
  run.has_switch = !problem.switch_times.empty();
  run.reached_end = out.report.status == RunStatus::reached_end;
  run.steps = out.report.accepted, run.rejected = out.report.rejected, run.evaluations = out.evaluations;
  run.share_over = double(over) / double(run.steps), run.zero_estimates = double(zeros) / double(run.steps);
  if (problem.invariants_call)
    run.energy_ratio = energy_of(problem, out.y) / energy_of(problem, problem.initial);
  return run;
}

}  // namespace

std::vector<AdaptiveRun> adaptive_runs() {
  std::vector<AdaptiveRun> runs;
  const auto both = [&](const AnyProblem& problem, double tolerance, double nominal, double t_end) {
    for (const char* method : {"chapter_adaptive_euler", "step_doubling_euler"})
      runs.push_back(adaptive_run(problem, {method, tolerance, nominal, t_end}));
  };
  for (const double tolerance : {1e-2, 1e-3, 1e-4}) both(problem_called("drag_ship"), tolerance, 0.5, 60);
  // the propeller is reversed: within a step's first half, where V2 sees it, and within its second, where it
  // does not
  for (const char* reversed : {"t_reverse=60.12", "t_reverse=60.3"})
    both(problem_called("drag_ship_quadratic", reversed), 1e-3, 0.5, 120);
  const AnyProblem spring = problem_called("oscillator", fmt::format("omega={:.17g},x0=0.1", 10 * pi));
  for (const double tolerance : {1e-1, 1e-2, 1e-3}) both(spring, tolerance, 1.0 / 60, 5);
  return runs;
}

ZeroEstimate zero_estimate() {
  ZeroEstimate out;
  const volatile double nothing = 0;  // the compiler must divide
  constexpr double dt = 0.5, allowed = 1e-3;
  out.wished = dt * std::sqrt(allowed / nothing);
  out.step_kept = !(out.wished < dt);
  out.wished_both = dt * std::sqrt(nothing / nothing);
  out.step_kept_both = !(out.wished_both < dt);
  out.at_limit =
      adaptive_run(problem_called("drag_ship", "v0=20"), {"chapter_adaptive_euler", allowed, dt, 60});
  return out;
}

}  // namespace odemark::chapter
