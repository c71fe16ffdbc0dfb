// Implicit Runge-Kutta methods with many stages: the way to a truth where a problem is stiff.
#pragma once

#include "reference/collocation_newton.hpp"

namespace odemark {

/// Radau IIA or Lobatto IIIC. The step follows the top Legendre coefficients of the polynomial through the
/// stages: they are at the tolerance, and the end of the step is far better.
class CollocationTruth : public TruthSolver {
 public:
  enum class Kind { radau, lobatto };
  CollocationTruth(Kind kind, RunTolerance tolerance, int stages = 21);
  std::string name() const override;
  void enter(const WideSystem& system) override;
  void advance(Wide& t, std::vector<Wide>& y, const Wide& stop, RunBudget& budget) override;
  /// One attempt at a step towards `stop`.
  void attempt(Wide& t, std::vector<Wide>& y, const Wide& stop, RunBudget& budget);

 private:
  void guess(const std::vector<Wide>& y, const Wide& step);
  long double step_bits(const std::vector<Wide>& y);

  Kind kind_;
  RunTolerance tolerance_;
  StiffStages method_;
  std::vector<Wide> transform_;  // of the values at `nodes_` to Legendre coefficients
  std::size_t nodes_;            // stages, and for Radau the start of the step
  CollocationNewton newton_;
  WideSystem system_;
  Wide step_ = 0, old_step_ = 0;
  std::vector<Wide> stage_, coefficients_;  // of the last step: coefficient k of component i at k * size + i
};

}  // namespace odemark
