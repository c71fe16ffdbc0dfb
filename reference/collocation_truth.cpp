#include "reference/collocation_truth.hpp"

#include <algorithm>
#include <cmath>

namespace odemark {

namespace {

constexpr double least_unit = 1e-12;

std::vector<Wide> nodes_of(const StiffStages& method, bool with_start) {
  std::vector<Wide> nodes = method.c;
  if (with_start) nodes.insert(nodes.begin(), Wide(0));
  return nodes;
}

}  // namespace

CollocationTruth::CollocationTruth(Kind kind, RunTolerance tolerance, int stages)
    : kind_(kind),
      tolerance_(std::move(tolerance)),
      method_(kind == Kind::radau ? radau_iia(stages) : lobatto_iiic(stages)),
      transform_(legendre_transform(nodes_of(method_, kind == Kind::radau))),
      nodes_(method_.stages + (kind == Kind::radau ? 1 : 0)),
      newton_(method_, tolerance_, least_unit) {}

std::string CollocationTruth::name() const {
  return (kind_ == Kind::radau ? "Radau IIA with " : "Lobatto IIIC with ") + std::to_string(method_.stages) +
         " stages";
}

void CollocationTruth::enter(const WideSystem& system) {
  system_ = system;
  newton_.enter(system);
  stage_.resize(method_.stages * system.size());
  coefficients_.resize(nodes_ * system.size());
  step_ = 0, old_step_ = 0;
}

/// The polynomial of the last step, continued.
void CollocationTruth::guess(const std::vector<Wide>& y, const Wide& step) {
  const std::size_t n = y.size();
  for (std::size_t j = 0; j < method_.stages; ++j) {
    if (old_step_ == 0) {
      std::copy(y.begin(), y.end(), stage_.begin() + std::ptrdiff_t(j * n));
      continue;
    }
    const auto p = legendre(1 + 2 * method_.c[j] * step / old_step_, int(nodes_) - 1);
    for (std::size_t i = 0; i < n; ++i) {
      Wide sum = 0;
      for (std::size_t k = 0; k < nodes_; ++k) sum += coefficients_[k * n + i] * p[k];
      stage_[j * n + i] = sum;
    }
  }
}

/// log2 of the factor by which the step may grow.
long double CollocationTruth::step_bits(const std::vector<Wide>& y) {
  const std::size_t n = y.size(), shift = nodes_ - method_.stages;
  for (std::size_t k = 0; k < nodes_; ++k)
    for (std::size_t i = 0; i < n; ++i) {
      Wide sum = shift ? Wide(transform_[k * nodes_] * y[i]) : Wide(0);
      for (std::size_t j = 0; j < method_.stages; ++j)
        sum += transform_[k * nodes_ + j + shift] * stage_[j * n + i];
      coefficients_[k * n + i] = sum;
    }
  const std::size_t degree = nodes_ - 1;
  const long double tolerance = tolerance_.bits();
  long double bits = 1e9L;
  for (std::size_t i = 0; i < n; ++i) {
    const Wide end = stage_[(method_.stages - 1) * n + i], size = abs(end) > abs(y[i]) ? abs(end) : abs(y[i]);
    const long double unit = log2_size(error_unit(size, least_unit, tolerance_.scale[i]));
    for (std::size_t k = degree - 3; k <= degree; ++k) {
      const long double c = log2_size(coefficients_[k * n + i]) - unit;
      bits = std::min(bits, tolerance / static_cast<long double>(degree) - c / static_cast<long double>(k));
    }
  }
  return bits;
}

void CollocationTruth::advance(Wide& t, std::vector<Wide>& y, const Wide& stop, RunBudget& budget) {
  while (t < stop) attempt(t, y, stop, budget);
}

void CollocationTruth::attempt(Wide& t, std::vector<Wide>& y, const Wide& stop, RunBudget& budget) {
  budget.spend();
  const std::size_t n = y.size();
  if (step_ == 0) step_ = first_step(system_, t, y, stop, tolerance_);
  // as few equal steps as lead to the stop
  const Wide whole = stop - t, pieces = ceil(whole / step_);
  const bool last = pieces <= 1;
  const Wide step = last ? whole : pieces <= 3 ? Wide(whole / pieces) : step_;
  if (!last && step < abs(t) * power_of_two(-130))
    throw RunFailed("its step shrinks without end near t = " + t.str(8));
  guess(y, step);
  if (!newton_.solve(t, y, step, stage_)) {
    step_ = step / 4;
    return;
  }
  const long double bits = step_bits(y);
  if (!(bits > -0.15L)) {
    step_ = step * power_of_two(std::clamp(bits - 0.2L, -4.0L, -0.5L));
    old_step_ = 0;  // the coefficients are those of the rejected step
    return;
  }
  for (std::size_t i = 0; i < n; ++i) y[i] = stage_[(method_.stages - 1) * n + i];
  t = last ? stop : Wide(t + step);
  old_step_ = step;
  const Wide wanted = step * power_of_two(std::clamp(bits - 0.1L, -1.0L, 3.0L));
  if (!last || wanted > step_) step_ = wanted;
}

}  // namespace odemark
