// Extrapolation of the explicit midpoint rule: the partner of Taylor series where a problem is not stiff.
#pragma once

#include "reference/truth_solver.hpp"

namespace odemark {

/// Gragg's method with the sequence 2, 4, 6, ... and a fixed number of columns (E. Hairer, S. P. Norsett, G.
/// Wanner, Solving Ordinary Differential Equations I, 2nd ed. (Springer, 1993), II.9): order twice the
/// columns.
class ExtrapolationTruth : public TruthSolver {
 public:
  explicit ExtrapolationTruth(RunTolerance tolerance, int columns = 12);
  std::string name() const override;
  void enter(const WideSystem& system) override;
  void advance(Wide& t, std::vector<Wide>& y, const Wide& stop, RunBudget& budget) override;

 private:
  void fill_table(const Wide& t, const std::vector<Wide>& y, const Wide& step);

  RunTolerance tolerance_;
  std::size_t columns_;
  WideSystem system_;
  Wide step_ = 0;
  std::vector<std::vector<Wide>> table_;  // the newest row T(j, 1) .. T(j, j), last column last
  std::vector<Wide> slope_, older_, newer_, scratch_;
  std::vector<Wide> previous_;  // T(columns, columns - 1)
};

}  // namespace odemark
