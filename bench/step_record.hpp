// Keeps the accepted steps of a run: their sizes for a picture, and their true local errors.
#pragma once

#include <vector>

#include "bench/data/row.hpp"
#include "integrators/step_control.hpp"
#include "reference/any_problem.hpp"

namespace odemark {

/// Called with every accepted state; steps beyond the first `most_steps` are not kept.
class StepRecord {
 public:
  StepRecord(const AnyProblem& problem, const std::vector<long double>& initial);

  void add(long double t, const std::vector<long double>& y);

  /// At most `most` steps, evenly taken.
  RowSteps history(std::size_t most) const;
  /// At most `most` steps, evenly taken, each against a Taylor series of order 20 in long double through its
  /// start, once in 4 and once in 8 parts: judged where both agree to a thousandth of the tolerance. The norm
  /// is the one that the control's own test uses.
  RowLocal local_errors(const ErrorControl& control, std::size_t most) const;

 private:
  static constexpr std::size_t most_steps = 100'000;
  const AnyProblem& problem_;
  std::vector<long double> times_, states_;
};

}  // namespace odemark
