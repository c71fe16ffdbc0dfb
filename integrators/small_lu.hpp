// I - diagonal * J, factored for systems of a few components: unrolled, with reciprocals of the pivots.
#pragma once

#include <array>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "integrators/dense_lu.hpp"

namespace odemark {

/// Up to here elimination is written out; beyond it DenseLu is faster.
inline constexpr std::size_t largest_small_lu = 8;

namespace detail {

/// Says whether the determinant is positive, as it is for short steps. `size` is a number or an
/// integral_constant: the same operations in the same order, so that a step gives the same bits whether the
/// size is known to the compiler or not. Matrices are column-major.
template <class Real, class Size>
[[gnu::always_inline]] inline bool small_lu_factorize(Size size, Real diagonal, const Real* jacobian,
                                                      Real* matrix, Real* reciprocal, std::size_t* pivot) {
  const std::size_t n = size;
  for (std::size_t j = 0; j < n; ++j)
    for (std::size_t i = 0; i < n; ++i)
      matrix[j * n + i] = Real(i == j ? 1 : 0) - diagonal * jacobian[j * n + i];
  bool positive = true;
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t best = k;
    Real largest = std::abs(matrix[k * n + k]);
    for (std::size_t i = k + 1; i < n; ++i)
      if (std::abs(matrix[k * n + i]) > largest) largest = std::abs(matrix[k * n + i]), best = i;
    pivot[k] = best;
    positive = positive != (best != k);
    // rows are compared, not indexed: a computed index would keep the matrix out of registers
    for (std::size_t i = k + 1; i < n; ++i)
      if (i == best)
        for (std::size_t j = 0; j < n; ++j) std::swap(matrix[j * n + k], matrix[j * n + i]);
    reciprocal[k] = Real(1) / matrix[k * n + k];
    positive = positive != (reciprocal[k] < 0);
    for (std::size_t i = k + 1; i < n; ++i) {
      const Real factor = matrix[k * n + i] * reciprocal[k];
      matrix[k * n + i] = factor;
      for (std::size_t j = k + 1; j < n; ++j) matrix[j * n + i] -= factor * matrix[j * n + k];
    }
  }
  return positive;
}

template <class Real, class Size>
[[gnu::always_inline]] inline void small_lu_solve(Size size, const Real* matrix, const Real* reciprocal,
                                                  const std::size_t* pivot, Real* rhs) {
  const std::size_t n = size;
  for (std::size_t k = 0; k < n; ++k)
    for (std::size_t i = k + 1; i < n; ++i)
      if (i == pivot[k]) std::swap(rhs[k], rhs[i]);
  for (std::size_t k = 0; k < n; ++k)
    for (std::size_t i = k + 1; i < n; ++i) rhs[i] -= matrix[k * n + i] * rhs[k];
  for (std::size_t k = n; k-- > 0;) {
    rhs[k] *= reciprocal[k];
    for (std::size_t i = 0; i < k; ++i) rhs[i] -= matrix[k * n + i] * rhs[k];
  }
}

}  // namespace detail

/// Size known to the compiler. A singular matrix gives infinities and NaN, which the step passes on.
template <class Real, std::size_t N>
class SmallLu {
 public:
  explicit SmallLu(std::size_t) {}
  Real* jacobian() { return jacobian_.data(); }
  [[gnu::always_inline]] bool factorize(Real diagonal) {
    return detail::small_lu_factorize(std::integral_constant<std::size_t, N>{}, diagonal, jacobian_.data(),
                                      matrix_.data(), reciprocal_.data(), pivot_.data());
  }
  [[gnu::always_inline]] void solve_in_place(Real* rhs) {
    detail::small_lu_solve(std::integral_constant<std::size_t, N>{}, matrix_.data(), reciprocal_.data(),
                           pivot_.data(), rhs);
  }

 private:
  std::array<Real, N * N> jacobian_{}, matrix_{};
  std::array<Real, N> reciprocal_{};
  std::array<std::size_t, N> pivot_{};
};

/// Size known at run time, any size: DenseLu above largest_small_lu. Compiled once per number type.
template <class Real>
class SmallLu<Real, 0> {
 public:
  explicit SmallLu(std::size_t size);
  Real* jacobian();
  bool factorize(Real diagonal);
  void solve_in_place(Real* rhs);

 private:
  std::size_t size_;
  std::unique_ptr<DenseLu<Real>> dense_;
  std::vector<Real> jacobian_, matrix_, reciprocal_;
  std::vector<std::size_t> pivot_;
};

extern template class SmallLu<float, 0>;
extern template class SmallLu<double, 0>;
extern template class SmallLu<long double, 0>;

/// For a state of N components, N = 0 where the type does not say.
template <class Real, std::size_t N>
using LuOfSize = std::conditional_t<(N > largest_small_lu), DenseLu<Real>, SmallLu<Real, N>>;

}  // namespace odemark
