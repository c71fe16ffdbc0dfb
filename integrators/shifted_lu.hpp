// shift I - J, factored, for real and complex shifts: inlined for up to eight components, compiled once else.
#pragma once

#include <array>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

#include "integrators/plain_complex.hpp"
#include "integrators/state.hpp"

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
    if (pivot != k)
      for (std::size_t j = 0; j < n; ++j) std::swap(a[j * n + k], a[j * n + pivot]);
    reciprocal[k] = reciprocal_of(a[k * n + k]);
    for (std::size_t i = k + 1; i < n; ++i) a[k * n + i] = a[k * n + i] * reciprocal[k];
    for (std::size_t j = k + 1; j < n; ++j) {
      const Scalar factor = a[j * n + k];
      for (std::size_t i = k + 1; i < n; ++i) a[j * n + i] = a[j * n + i] - a[k * n + i] * factor;
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
    } else {  // comparisons instead of an address keep b in registers
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
/// Column-major `out` = shift I - jacobian.
template <class Real, class Scalar, class Size>
[[gnu::always_inline]] inline void shift_matrix(const Real* jacobian, Scalar shift, Scalar* out, Size size) {
  const std::size_t n = size;
  for (std::size_t i = 0; i < n * n; ++i) out[i] = Scalar{-jacobian[i]};
  for (std::size_t i = 0; i < n; ++i) out[i * n + i] = shift + out[i * n + i];
}

/// The size to compile for: that of a small array, else 0 for a size known at run time.
template <class S>
inline constexpr std::size_t inlined_size = fixed_size<S> <= 8 ? fixed_size<S> : 0;

/// Scalar is Real or PlainComplex<Real>. `jacobian` is column-major, size x size.
template <class Real, class Scalar, std::size_t N>
class ShiftedLu {
 public:
  explicit ShiftedLu(std::size_t) {}
  void factorize(const Real* jacobian, Scalar shift) {
    shift_matrix(jacobian, shift, matrix_.data(), Size{});
    lu_factorize(matrix_.data(), reciprocal_.data(), row_.data(), Size{});
  }
  void solve_in_place(Scalar* b) const {
    lu_solve(matrix_.data(), reciprocal_.data(), row_.data(), b, Size{});
  }

 private:
  using Size = std::integral_constant<std::size_t, N>;
  std::array<Scalar, N * N> matrix_;
  std::array<Scalar, N> reciprocal_;
  std::array<std::size_t, N> row_;
};

template <class Real, class Scalar>
class ShiftedLu<Real, Scalar, 0> {
 public:
  explicit ShiftedLu(std::size_t size);
  void factorize(const Real* jacobian, Scalar shift);
  void solve_in_place(Scalar* b) const;

 private:
  std::size_t size_;
  std::vector<Scalar> matrix_, reciprocal_;
  std::vector<std::size_t> row_;
};

extern template class ShiftedLu<float, float, 0>;
extern template class ShiftedLu<double, double, 0>;
extern template class ShiftedLu<long double, long double, 0>;
extern template class ShiftedLu<float, PlainComplex<float>, 0>;
extern template class ShiftedLu<double, PlainComplex<double>, 0>;
extern template class ShiftedLu<long double, PlainComplex<long double>, 0>;

}  // namespace odemark
