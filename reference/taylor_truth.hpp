// Explicit Taylor series of high order: the first way to a truth where a problem is not too stiff.
#pragma once

#include <memory>

#include "integrators/taylor_series.hpp"
#include "reference/truth_solver.hpp"

namespace odemark {

/// Taylor series with the order fitted to the tolerance (A. Jorba, M. Zou, Experimental Mathematics 14 (2005)
/// 99-117, doi:10.1080/10586458.2005.10128904: about 1.2 times the digits) and the step from the last eight
/// coefficients: fewer are blind to series with gaps. Where the right-hand side has kinks of abs, the series
/// is that of the branch at hand, and the instant at which the argument of abs changes its sign is found on
/// the series and stepped to.
class TaylorTruth : public TruthSolver {
 public:
  explicit TaylorTruth(RunTolerance tolerance);
  std::string name() const override;
  void enter(const WideSystem& system) override;
  void advance(Wide& t, std::vector<Wide>& y, const Wide& stop, RunBudget& budget) override;
  std::vector<Wide> kinks() const override { return kinks_; }  // where an argument of abs changed its sign

 private:
  struct Kink {
    std::size_t entry, argument;  // on the tape
    bool negative = false;        // the branch at hand
    bool here = false;            // the argument vanishes at the present instant
  };
  void choose_branches(const Wide& t, const std::vector<Wide>& y);
  void set_branch(Kink& kink, bool negative);
  long double step_bits(const std::vector<Wide>& y) const;
  bool first_crossing(const Kink& kink, const Wide& step, Wide& crossing) const;

  RunTolerance tolerance_;
  int order_;
  Tape<Wide> smooth_;  // every abs replaced by its branch
  std::unique_ptr<TaylorSeries<Wide>> series_;
  std::vector<Kink> branches_;
  std::vector<Wide> kinks_;
};

}  // namespace odemark
