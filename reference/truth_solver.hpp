// What every solver of truths has in common: the system it sees, the budget it has, how it fails.
#pragma once

#include <chrono>
#include <stdexcept>
#include <string>
#include <vector>

#include "reference/wide_problem.hpp"

namespace odemark {

/// One phase of a problem. A view: the problem outlives it.
struct WideSystem {
  const WideProblem* problem = nullptr;
  const WidePhase* phase = nullptr;

  std::size_t size() const { return problem->size; }
  void rhs(const Wide& t, const Wide* y, Wide* dydt) const { problem->rhs(phase->value.get(), t, y, dydt); }
  void jacobian(const Wide& t, const Wide* y, Wide* column_major) const {
    problem->jacobian(phase->value.get(), t, y, column_major);
  }
};

/// Why a run came to no end, in half a sentence.
struct RunFailed : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Steps and time that a run may take.
struct RunBudget {
  std::chrono::steady_clock::time_point deadline = std::chrono::steady_clock::time_point::max();
  long steps_left = 20'000'000;

  /// Counts one step; throws RunFailed where none is left.
  void spend() {
    if (--steps_left < 0) throw RunFailed("it takes too many steps");
    if (std::chrono::steady_clock::now() > deadline) throw RunFailed("the time allowed is over");
  }
};

/// Local errors are measured component by component in units of max(|y|, floor * scale).
struct RunTolerance {
  double exponent = -34;  // the local error is at most 10^exponent of those units
  std::vector<double> scale;

  long double bits() const { return static_cast<long double>(exponent) * 3.3219280948873623L; }
};

/// One way to solve, for one run. Implementations share no code that could be wrong in all of them.
class TruthSolver {
 public:
  virtual ~TruthSolver() = default;
  virtual std::string name() const = 0;
  /// From now on this system: at the start and at every switch time.
  virtual void enter(const WideSystem& system) = 0;
  /// Moves t to `stop` exactly, and y with it. Throws RunFailed.
  virtual void advance(Wide& t, std::vector<Wide>& y, const Wide& stop, RunBudget& budget) = 0;
  /// Instants found on the way at which the right-hand side has a kink.
  virtual std::vector<Wide> kinks() const { return {}; }
};

/// log2 |x| in range of any exponent; about -1e9 for 0.
long double log2_size(const Wide& x);
/// max(|y|, floor * scale), never 0.
Wide error_unit(const Wide& y, double floor, double scale);
/// 2^x, x of any size that Wide can hold.
Wide power_of_two(long double x);
/// A first step from the sizes of y and y': a small part of the time in which y changes by its own size.
Wide first_step(const WideSystem& system, const Wide& t, const std::vector<Wide>& y, const Wide& stop,
                const RunTolerance& tolerance);

}  // namespace odemark
