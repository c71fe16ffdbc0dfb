// shift I - J or I - diagonal J, factored: whole or banded, for real and complex shifts; inlined for up to
// eight components, compiled once else.
#pragma once

#include <array>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

#include "integrators/jacobian.hpp"
#include "integrators/plain_complex.hpp"

namespace odemark {

/// Rows are exchanged for the largest pivot of a column; reciprocals of the pivots are stored, because a
/// division costs as much as a whole row of a small matrix. `Size` is std::size_t or an integral constant:
/// the operations and so the bits are the same.
template <class Scalar, class Size>
[[gnu::always_inline]] inline void lu_factorize(Scalar* a, Scalar* reciprocal, std::size_t* row, Size size) {
  const std::size_t n = size;
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t pivot = k;
    auto largest = magnitude_of(a[k * n + k]);
    for (std::size_t i = k + 1; i < n; ++i)
      if (const auto m = magnitude_of(a[k * n + i]); m > largest) pivot = i, largest = m;
    row[k] = pivot;
    if constexpr (std::is_same_v<Size, std::size_t>) {
      if (pivot != k)
        for (std::size_t j = 0; j < n; ++j) std::swap(a[j * n + k], a[j * n + pivot]);
    } else {  // comparisons instead of an address keep the matrix in registers
      for (std::size_t i = k + 1; i < n; ++i)
        if (i == pivot)
          for (std::size_t j = 0; j < n; ++j) std::swap(a[j * n + k], a[j * n + i]);
    }
    reciprocal[k] = reciprocal_of(a[k * n + k]);
    if constexpr (std::is_same_v<Size, std::size_t>) {
      for (std::size_t i = k + 1; i < n; ++i) a[k * n + i] = a[k * n + i] * reciprocal[k];
      for (std::size_t j = k + 1; j < n; ++j) {
        const Scalar factor = a[j * n + k];
        for (std::size_t i = k + 1; i < n; ++i) a[j * n + i] = a[j * n + i] - a[k * n + i] * factor;
      }
    } else {
      for (std::size_t i = k + 1; i < n; ++i) {
        const Scalar factor = a[k * n + i] * reciprocal[k];
        a[k * n + i] = factor;
        for (std::size_t j = k + 1; j < n; ++j) a[j * n + i] = a[j * n + i] - factor * a[j * n + k];
      }
    }
  }
}
template <class Scalar, class Size>
[[gnu::always_inline]] inline void lu_solve(const Scalar* a, const Scalar* reciprocal, const std::size_t* row,
                                            Scalar* b, Size size) {
  const std::size_t n = size;
  for (std::size_t k = 0; k < n; ++k) {
    if constexpr (std::is_same_v<Size, std::size_t>) {
      std::swap(b[k], b[row[k]]);
    } else {
      for (std::size_t i = k + 1; i < n; ++i)
        if (row[k] == i) std::swap(b[k], b[i]);
    }
  }
  for (std::size_t k = 0; k < n; ++k)
    for (std::size_t i = k + 1; i < n; ++i) b[i] = b[i] - a[k * n + i] * b[k];
  for (std::size_t k = n; k-- > 0;) {
    b[k] = b[k] * reciprocal[k];
    for (std::size_t i = 0; i < k; ++i) b[i] = b[i] - a[k * n + i] * b[k];
  }
}
/// Is the determinant positive, as that of I - diagonal J is for short steps?
template <class Real>
[[gnu::always_inline]] inline bool lu_is_positive(const Real* reciprocal, const std::size_t* row,
                                                  std::size_t size) {
  bool is_positive = true;
  for (std::size_t k = 0; k < size; ++k) {
    is_positive = is_positive != (row[k] != k);
    is_positive = is_positive != (reciprocal[k] < 0);
  }
  return is_positive;
}
/// Column-major `out` = shift I - jacobian.
template <class Real, class Scalar, class Size>
[[gnu::always_inline]] inline void shift_matrix(const Real* jacobian, Scalar shift, Scalar* out, Size size) {
  const std::size_t n = size;
  for (std::size_t i = 0; i < n * n; ++i) out[i] = Scalar{-jacobian[i]};
  for (std::size_t i = 0; i < n; ++i) out[i * n + i] = shift + out[i * n + i];
}
/// Column-major `out` = I - diagonal jacobian.
template <class Real, class Scalar, class Size>
[[gnu::always_inline]] inline void step_matrix(const Real* jacobian, Scalar diagonal, Scalar* out,
                                               Size size) {
  const std::size_t n = size;
  for (std::size_t j = 0; j < n; ++j)
    for (std::size_t i = 0; i < n; ++i)
      out[j * n + i] = Scalar{Real(i == j ? 1 : 0)} - diagonal * Scalar{jacobian[j * n + i]};
}

/// Scalar is Real or PlainComplex<Real>. A singular matrix gives infinities and NaN, which the step passes
/// on.
template <class Real, class Scalar = Real, std::size_t N = 0>
class ShiftedLu {
 public:
  explicit ShiftedLu(const MatrixShape&) {}
  /// Of shift I - jacobian.
  void factorize(const JacobianMatrix<Real, N>& jacobian, Scalar shift) {
    shift_matrix(jacobian.data(), shift, matrix_.data(), Size{});
    lu_factorize(matrix_.data(), reciprocal_.data(), row_.data(), Size{});
  }
  /// Of I - diagonal jacobian.
  [[gnu::always_inline]] void factorize_step(const JacobianMatrix<Real, N>& jacobian, Scalar diagonal) {
    step_matrix(jacobian.data(), diagonal, matrix_.data(), Size{});
    lu_factorize(matrix_.data(), reciprocal_.data(), row_.data(), Size{});
  }
  [[gnu::always_inline]] bool has_positive_determinant() const {
    return lu_is_positive(reciprocal_.data(), row_.data(), N);
  }
  [[gnu::always_inline]] void solve_in_place(Scalar* b) const {
    lu_solve(matrix_.data(), reciprocal_.data(), row_.data(), b, Size{});
  }

 private:
  using Size = std::integral_constant<std::size_t, N>;
  std::array<Scalar, N * N> matrix_;
  std::array<Scalar, N> reciprocal_;
  std::array<std::size_t, N> row_;
};

/// The same for a size and shape known at run time. A banded matrix is stored with room for the rows that
/// pivoting moves up: element (i, j) at j (2 lower + upper + 1) + lower + upper + i - j.
template <class Real, class Scalar>
class ShiftedLu<Real, Scalar, 0> {
 public:
  explicit ShiftedLu(const MatrixShape& shape);
  void factorize(const JacobianMatrix<Real>& jacobian, Scalar shift);
  void factorize_step(const JacobianMatrix<Real>& jacobian, Scalar diagonal);
  template <class = void>  // of real matrices only, so compiled where it is asked for
  bool has_positive_determinant() const {
    return lu_is_positive(reciprocal_.data(), row_.data(), shape_.size);
  }
  void solve_in_place(Scalar* b);

 private:
  void factorize_matrix();

  MatrixShape shape_;
  std::vector<Scalar> matrix_, reciprocal_;
  std::vector<Scalar> shuffled_;  // a right-hand side in the order of the band
  std::vector<std::size_t> row_;
};

extern template class ShiftedLu<float, float, 0>;
extern template class ShiftedLu<double, double, 0>;
extern template class ShiftedLu<long double, long double, 0>;
extern template class ShiftedLu<float, PlainComplex<float>, 0>;
extern template class ShiftedLu<double, PlainComplex<double>, 0>;
extern template class ShiftedLu<long double, PlainComplex<long double>, 0>;

}  // namespace odemark
