#include "bench/settling.hpp"

#include <cmath>

#include "bench/run.hpp"
#include "integrators/linear_stability.hpp"

namespace odemark {

namespace {

constexpr double rate = 2000, t_end = 1.5;

ErasedSystem<double> settling_problem() {
  ErasedSystem<double> system;
  system.size = 1;
  system.rhs_call = [](const void*, double t, const double* y, double* dydt) {
    dydt[0] = -rate * (y[0] - std::cos(t));
  };
  return system;
}

/// End of the real stability interval; 0 where there is none that ends, or where no step size is filtered.
double limit_of(const AnyMethod& method) {
  if (method.provider != "odemark" || !method.takes_error_control || method.own_step_control) return 0;
  const Theory theory = method.theory();
  if (theory.numerator.empty() || theory.denominator.size() != 1) return 0;
  const StabilityLimit limit = stability_limit(theory, linear_problem(1, {-1}, false));
  return limit.verdict == Stability::limit ? double(limit.limit) : 0;
}

Settling settle(const AnyMethod& method, const StepFilter& filter, double limit) {
  Settling result{std::string(method.id), std::string(filter.id), "", limit, 0, 0, 0, 0};
  const auto system = settling_problem();
  ErrorControl control{1e-3, 1e-3, filter};
  control.step_limit = 200'000;
  std::vector<double> y{0};
  double before = 0, count = 0, sum = 0, squares = 0;
  Trace<double> trace;
  trace.on_step = [&](double t, const double*) {
    // the last step is cut to the end
    if (before > t_end / 2 && t < t_end) {
      const double z = (t - before) * rate;
      count += 1, sum += z, squares += z * z;
    }
    before = t;
    return true;
  };
  const RunReport report = method.runs<double>().solve_traced(system, system, control, 0, t_end, y, trace);
  result.status = to_string(report.status);
  result.accepted = report.accepted, result.rejected = report.rejected;
  if (count > 0) {
    result.mean = sum / count;
    result.scatter = std::sqrt(std::max(0.0, squares / count - result.mean * result.mean)) / result.mean;
  }
  return result;
}

}  // namespace

std::vector<Settling> measure_settling(const std::vector<AnyMethod>& methods) {
  std::vector<Settling> all;
  for (const AnyMethod& method : methods)
    if (const double limit = limit_of(method); limit > 0 && method.runs<double>().solve_traced)
      for (const StepFilter* filter : step_filters) all.push_back(settle(method, *filter, limit));
  return all;
}

}  // namespace odemark
