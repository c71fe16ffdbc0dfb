// Newton's method on all stages of an implicit step at once: residuals in wide arithmetic, matrices in a
// narrower one.
#pragma once

#include "reference/collocation_linear.hpp"
#include "reference/collocation_nodes.hpp"
#include "reference/truth_solver.hpp"

namespace odemark {

/// Solves Y_i = y + h sum_j a_ij f(t + c_j h, Y_j). The residual decides what is solved; the matrix only how
/// fast, so it is factorised in long double, with rows and columns scaled, and not again once it is near
/// enough. Where that does not contract, everything is done again with a matrix in wide arithmetic.
class CollocationNewton {
 public:
  CollocationNewton(const StiffStages& method, const RunTolerance& tolerance, double floor);
  void enter(const WideSystem& system);
  /// `stage` holds a guess, stage by stage, and then the solution. Returns false where Newton fails.
  bool solve(const Wide& t, const std::vector<Wide>& y, const Wide& h, std::vector<Wide>& stage);

 private:
  template <class Number>
  bool iterate(const Wide& t, const std::vector<Wide>& y, const Wide& h, std::vector<Wide>& stage,
               WideLu<Number>& lu, int limit);
  template <class Number>
  bool factor(const Wide& t, const Wide& h, const std::vector<Wide>& stage, WideLu<Number>& lu);
  void residual(const Wide& t, const std::vector<Wide>& y, const Wide& h, const std::vector<Wide>& stage);

  const StiffStages& method_;
  RunTolerance tolerance_;
  double floor_;
  WideSystem system_;
  WideLu<long double> fast_;
  WideLu<Wide> sure_;
  std::vector<Wide> slopes_, residual_, jacobian_, unit_, guess_;
};

}  // namespace odemark
