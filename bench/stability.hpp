// Stability limits of the compiled steppers against those of their coefficients, and "will it explode at my
// dt?".
#pragma once

#include <atomic>
#include <functional>
#include <optional>
#include <set>
#include <string>

#include "bench/data/stability.hpp"
#include "integrators/any_method.hpp"
#include "integrators/linear_stability.hpp"
#include "reference/any_problem.hpp"

namespace odemark {

/// The spectrum of a linear problem. Throws std::invalid_argument for a problem that is not linear.
LinearProblem linear_problem(const AnyProblem& problem);

struct StabilityOptions {
  unsigned jobs = 1;
  std::string scalar = "double";  // or "float"
  /// Called with every row in their order, one call at a time: what is handed over survives an interruption.
  std::function<void(std::size_t done, std::size_t total, const StabilityRow&)> progress;
  /// Pairs measured before, as "problem/method": left out.
  std::set<std::string> done = {};
  const std::atomic<bool>* stop = nullptr;  // leaves out the rest
};

/// The oscillator, damped springs of five damping ratios, every stiff spring, the ship.
std::vector<AnyProblem> default_stability_problems();

/// Of these, the linear ones: each once. Not the large ones, whose matrices have too many entries.
std::vector<AnyProblem> linear_problems(const std::vector<AnyProblem>& problems);

/// A row for every pair, problem by problem, methods in their order; where there is nothing to measure, a
/// blank row with the reason.
std::vector<StabilityRow> measure_stability(const std::vector<AnyMethod>& methods,
                                            const std::vector<AnyProblem>& problems,
                                            const StabilityOptions& options = {});
StabilityRow measure_stability(const AnyMethod& method, const AnyProblem& problem,
                               const std::string& scalar = "double");

/// Where measurement and theory disagree beyond the resolution, one sentence each; empty when all is well.
std::vector<std::string> stability_faults(const std::vector<StabilityRow>& rows);

struct DtVerdict {
  std::string verdict, reason;   // "stable", "unstable" or "blank"
  bool unlimited = false;        // stable at every dt
  std::optional<double> limit;   // s; 0 where every dt is unstable
  std::optional<double> margin;  // limit / dt
  double growth_per_second = 0;  // ln(amplitude) per second at this dt; negative: decays
  std::optional<long> substeps;  // smallest n with dt / n stable; absent where there is none
};

/// Measured on the compiled stepper in double. Throws std::invalid_argument unless dt is positive and finite.
DtVerdict check_dt(const AnyMethod& method, const AnyProblem& problem, double dt);

}  // namespace odemark
