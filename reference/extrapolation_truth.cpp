#include "reference/extrapolation_truth.hpp"

#include <algorithm>
#include <cmath>

namespace odemark {

ExtrapolationTruth::ExtrapolationTruth(RunTolerance tolerance, int columns)
    : tolerance_(std::move(tolerance)), columns_(std::size_t(columns)), table_(columns_) {}

std::string ExtrapolationTruth::name() const {
  return "extrapolation of the midpoint rule, order " + std::to_string(2 * columns_);
}

void ExtrapolationTruth::enter(const WideSystem& system) {
  system_ = system;
  step_ = 0;
  for (auto* v : {&slope_, &older_, &newer_, &scratch_, &previous_}) v->resize(system.size());
  for (auto& row : table_) row.resize(system.size());
}

/// table_[c] ends as T(columns, c + 1): table_[0] holds the last midpoint result, the back the best value.
void ExtrapolationTruth::fill_table(const Wide& t, const std::vector<Wide>& y, const Wide& step) {
  std::vector<Wide> start(y.size());
  system_.rhs(t, y.data(), start.data());
  for (std::size_t j = 0; j < columns_; ++j) {
    const int pieces = 2 * int(j + 1);
    const Wide h = step / pieces, two_h = 2 * h;
    older_ = y;
    for (std::size_t i = 0; i < y.size(); ++i) newer_[i] = y[i] + h * start[i];
    for (int m = 1; m < pieces; ++m) {
      system_.rhs(t + h * m, newer_.data(), slope_.data());
      for (std::size_t i = 0; i < y.size(); ++i) older_[i] += two_h * slope_[i];
      older_.swap(newer_);
    }
    // Aitken-Neville in h^2, in place: `newer_` is T(j+1, c+1), table_[c] still T(j, c+1)
    for (std::size_t c = 0; c < j; ++c) {
      const int finer = int(j + 1), coarser = int(j - c);
      const Wide divisor = Wide(finer * finer - coarser * coarser) / (coarser * coarser);
      for (std::size_t i = 0; i < y.size(); ++i)
        scratch_[i] = newer_[i] + (newer_[i] - table_[c][i]) / divisor;
      table_[c].swap(newer_);
      newer_.swap(scratch_);
    }
    table_[j] = newer_;
  }
}

void ExtrapolationTruth::advance(Wide& t, std::vector<Wide>& y, const Wide& stop, RunBudget& budget) {
  // near zeros of a component the unit must stay above what rounding leaves of a step
  const double floor = std::clamp(std::pow(10.0, -43 - tolerance_.exponent), 1e-8, 0.1);
  const auto tolerance = tolerance_.bits();
  if (step_ == 0) step_ = first_step(system_, t, y, stop, tolerance_) / 10;
  int rejections = 0;
  while (t < stop) {
    budget.spend();
    const Wide whole = stop - t;
    const bool last = step_ >= whole;
    const Wide step = last ? whole : step_;
    fill_table(t, y, step);
    long double error = -1e9L;
    for (std::size_t i = 0; i < y.size(); ++i) {
      const Wide& best = table_[columns_ - 1][i];
      const long double e = isfinite(best) ? log2_size(best - table_[columns_ - 2][i]) -
                                                 log2_size(error_unit(best, floor, tolerance_.scale[i]))
                                           : 1e4L;
      error = std::max(error, e);
    }
    const long double change =
        std::clamp((tolerance - error) / static_cast<long double>(2 * columns_ - 1) - 0.2L, -3.0L, 2.0L);
    if (error > tolerance) {
      if (++rejections > 60) throw RunFailed("its step shrinks without end near t = " + t.str(8));
      step_ = step * power_of_two(change);
      continue;
    }
    rejections = 0;
    y = table_[columns_ - 1];
    t = last ? stop : Wide(t + step);
    const Wide wanted = step * power_of_two(change);
    if (!last || wanted > step_) step_ = wanted;
  }
}

}  // namespace odemark
