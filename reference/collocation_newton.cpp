#include "reference/collocation_newton.hpp"

#include <algorithm>
#include <cmath>

namespace odemark {

CollocationNewton::CollocationNewton(const StiffStages& method, const RunTolerance& tolerance, double floor)
    : method_(method), tolerance_(tolerance), floor_(floor) {}

void CollocationNewton::enter(const WideSystem& system) {
  system_ = system;
  const std::size_t all = method_.stages * system.size();
  slopes_.resize(all), residual_.resize(all), unit_.resize(system.size()),
      jacobian_.resize(system.size() * system.size());
}

void CollocationNewton::residual(const Wide& t, const std::vector<Wide>& y, const Wide& h,
                                 const std::vector<Wide>& stage) {
  const std::size_t s = method_.stages, n = y.size();
  for (std::size_t j = 0; j < s; ++j) system_.rhs(t + method_.c[j] * h, &stage[j * n], &slopes_[j * n]);
  for (std::size_t i = 0; i < s; ++i)
    for (std::size_t k = 0; k < n; ++k) {
      Wide sum = method_.a[i * s] * slopes_[k];
      for (std::size_t j = 1; j < s; ++j) sum += method_.a[i * s + j] * slopes_[j * n + k];
      residual_[i * n + k] = (y[k] - stage[i * n + k]) + h * sum;
    }
}

/// The matrix I - h A (x) J of the unknowns in units of their size.
template <class Number>
bool CollocationNewton::factor(const Wide& t, const Wide& h, const std::vector<Wide>& stage,
                               WideLu<Number>& lu) {
  const std::size_t s = method_.stages, n = system_.size(), all = s * n;
  std::vector<Number> matrix(all * all), weights(s * s);
  for (std::size_t i = 0; i < s * s; ++i) weights[i] = static_cast<Number>(method_.a[i]);
  for (std::size_t j = 0; j < s; ++j) {
    system_.jacobian(t + method_.c[j] * h, &stage[j * n], jacobian_.data());
    for (std::size_t row = 0; row < n; ++row)
      for (std::size_t column = 0; column < n; ++column) {
        const Wide& slope = jacobian_[column * n + row];
        if (slope == 0) continue;
        const Number scaled = static_cast<Number>(Wide(h * slope * unit_[column] / unit_[row]));
        for (std::size_t i = 0; i < s; ++i)
          matrix[(i * n + row) * all + j * n + column] = -weights[i * s + j] * scaled;
      }
  }
  for (std::size_t i = 0; i < all; ++i) matrix[i * all + i] += Number(1);
  return lu.factor(std::move(matrix), all);
}

template <class Number>
bool CollocationNewton::iterate(const Wide& t, const std::vector<Wide>& y, const Wide& h,
                                std::vector<Wide>& stage, WideLu<Number>& lu, int limit) {
  const std::size_t n = y.size(), all = stage.size();
  const long double enough = tolerance_.bits() - 16;
  const long double near = -33;  // a matrix from here is as good as its arithmetic
  long double before = 1e9L;
  bool stale = true;
  std::vector<Number> update(all);
  for (int iteration = 0; iteration < limit; ++iteration) {
    if (stale) {
      for (std::size_t i = 0; i < n; ++i) {
        Wide largest = y[i];
        for (std::size_t k = i; k < all; k += n)
          if (abs(stage[k]) > abs(largest)) largest = stage[k];
        unit_[i] = error_unit(largest, floor_, tolerance_.scale[i]);
      }
      if (!factor(t, h, stage, lu)) return false;
    }
    residual(t, y, h, stage);
    for (std::size_t i = 0; i < all; ++i) update[i] = static_cast<Number>(Wide(residual_[i] / unit_[i % n]));
    lu.solve(update.data());
    long double size = -1e9L;
    for (std::size_t i = 0; i < all; ++i) {
      const Wide change = Wide(update[i]);
      if (!isfinite(change)) return false;
      size = std::max(size, log2_size(change));
      stage[i] += change * unit_[i % n];
    }
    if (size < enough) return true;
    const bool slow = size > before - 3;
    if (slow && size < enough + 12) return true;  // down to rounding, and near enough
    if (iteration > 3 && slow && !stale) {
      stale = true;
    } else {
      stale = size > near;
    }
    before = size;
  }
  return false;
}

bool CollocationNewton::solve(const Wide& t, const std::vector<Wide>& y, const Wide& h,
                              std::vector<Wide>& stage) {
  guess_ = stage;
  if (iterate(t, y, h, stage, fast_, 14)) return true;
  stage = guess_;
  return iterate(t, y, h, stage, sure_, 10);
}

}  // namespace odemark
