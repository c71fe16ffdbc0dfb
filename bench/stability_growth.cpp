// Growth of a step: matrix powers by squaring, and what rounding can do to the answer.
#include "bench/stability_growth.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace odemark {

namespace {

using Wide = long double;

template <class Real>
std::vector<Real> product(std::size_t n, const std::vector<Real>& a, const std::vector<Real>& b) {
  std::vector<Real> out(n * n, 0);
  for (std::size_t c = 0; c < n; ++c)
    for (std::size_t k = 0; k < n; ++k)
      for (std::size_t r = 0; r < n; ++r) out[c * n + r] += a[k * n + r] * b[c * n + k];
  return out;
}

/// From trace and determinant, so that two eigenvalues which nearly meet on the circle cost no digits: powers
/// of such a matrix are ill-conditioned.
Wide growth_of_two_by_two(Wide a, Wide c, Wide b, Wide d) {
  const Wide largest = std::max({std::abs(a), std::abs(b), std::abs(c), std::abs(d)});
  if (!std::isfinite(largest)) return std::numeric_limits<Wide>::quiet_NaN();
  if (largest == 0) return -std::numeric_limits<Wide>::infinity();
  const Wide half = (a / 2 - d / 2) / largest, product = (b / largest) * (c / largest);
  const Wide square = half * half + product;
  if (square <= 4 * std::numeric_limits<Wide>::epsilon() * (half * half + std::abs(product)))
    return std::log(std::abs((a / largest) * (d / largest) - product)) / 2 + std::log(largest);
  return std::log(std::abs((a / 2 + d / 2) / largest) + std::sqrt(square)) + std::log(largest);
}

template <class Real>
Real squared_growth(std::size_t size, std::vector<Real> matrix, int most) {
  Real growth = 0, weight = 1;
  for (int squarings = 0; squarings < most; ++squarings) {
    Real norm = 0;
    for (const Real entry : matrix) {
      if (!std::isfinite(entry)) return std::numeric_limits<Real>::quiet_NaN();
      norm = std::max(norm, std::abs(entry));
    }
    // exactly 0 early is a nilpotent matrix; late it is a Jordan block whose growth has long been summed
    if (norm == 0) return squarings < 8 ? -std::numeric_limits<Real>::infinity() : growth;
    growth += weight * std::log(norm);
    weight /= 2;
    for (Real& entry : matrix) entry /= norm;
    matrix = product(size, matrix, matrix);
  }
  return growth;
}

}  // namespace

long double matrix_growth(std::size_t size, const std::vector<long double>& matrix) {
  if (size == 2) return growth_of_two_by_two(matrix[0], matrix[1], matrix[2], matrix[3]);
  return growth_by_squaring(size, matrix);
}

long double plain_growth(std::size_t size, const std::vector<long double>& matrix) {
  if (size == 2) return matrix_growth(size, matrix);
  const double growth = squared_growth<double>(size, {matrix.begin(), matrix.end()}, 54);
  if (std::isfinite(growth) && std::abs(growth) > 1e-3) return static_cast<long double>(growth);
  return matrix_growth(size, matrix);
}

long double growth_by_squaring(std::size_t size, std::vector<long double> matrix) {
  return squared_growth(size, std::move(matrix), 80);
}

template <class T>
void StepProbe::prepare(const AnyMethod& method, const ErasedSystem<T>& system) {
  unit_ = double(std::numeric_limits<T>::epsilon()) / 2;
  size_ = system.size;
  terms_ = std::max(2, method.order);
  std::vector<T> y(size_, T(0)), jacobian(size_ * size_, T(0));
  system.jacobian(T(0), y, MatrixView<T>{jacobian.data(), size_});
  jacobian_.assign(jacobian.begin(), jacobian.end());
  if (const auto transition = method.runs<T>().transition)
    step_ = [transition, &system](double dt) {
      const auto m = transition(system, T(dt));
      return Step{m.solved, m.size, {m.columns.begin(), m.columns.end()}};
    };
}

StepProbe::StepProbe(const AnyMethod& method, const ErasedSystem<double>& system) { prepare(method, system); }
StepProbe::StepProbe(const AnyMethod& method, const ErasedSystem<float>& system) { prepare(method, system); }

double StepProbe::tolerance(double z) const { return std::max(1e-12, 50 * unit_ * std::max(1.0, z)); }

StepGrowth StepProbe::operator()(double dt) const {
  const Step step = step_(dt);
  return {step.solved, matrix_growth(step.size, step.matrix)};
}

StepGrowth StepProbe::judge(double dt) const {
  const Step step = step_(dt);
  return {step.solved, plain_growth(step.size, step.matrix)};
}

/// Which of the moved matrices has real and which complex eigenvalues is chance, so neighbours are asked as
/// well.
long double StepProbe::noise(double dt) const {
  Wide worst = 0;
  for (int k = -2; k <= 2; ++k) worst = std::max(worst, noise_of(step_(dt * (1 + k * 1e-8)), dt));
  return 2 * worst;
}

/// Moves every entry by a few roundings of the terms it was summed from: those of exp(|J| dt), as many as the
/// method's order. Near a double eigenvalue this is the square root of a rounding, far above the rounding
/// itself.
long double StepProbe::noise_of(const Step& step, double dt) const {
  const Wide growth = matrix_growth(step.size, step.matrix);
  if (!std::isfinite(growth)) return 0;
  std::vector<Wide> scale(step.size * step.size, 0), term(size_ * size_, 0), rate(jacobian_);
  for (Wide& entry : rate) entry = std::abs(entry) * Wide(dt);
  for (std::size_t i = 0; i < size_; ++i) term[i * size_ + i] = 1;
  for (int k = 1; k <= terms_ + 1; ++k) {
    for (std::size_t c = 0; c < size_; ++c)
      for (std::size_t r = 0; r < size_; ++r) scale[c * step.size + r] += term[c * size_ + r];
    term = product(size_, rate, term);
    for (Wide& entry : term) entry /= Wide(k);
  }
  Wide sum = 0;
  for (std::size_t i = 0; i < scale.size(); ++i) {
    const Wide move = 4 * Wide(unit_) * (scale[i] + std::abs(step.matrix[i]));
    if (move == 0) continue;
    Wide worst = 0;
    for (const Wide sign : {-1.0L, 1.0L}) {
      auto moved = step.matrix;
      moved[i] += sign * move;
      worst = std::max(worst, std::abs(matrix_growth(step.size, moved) - growth));
    }
    sum += worst;
  }
  return sum;
}

}  // namespace odemark
