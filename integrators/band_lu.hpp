// A banded matrix factored with row exchanges, as LINPACK's dgbfa does it.
#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>

#include "integrators/plain_complex.hpp"

namespace odemark {

/// Element (i, j) lies at j rows() + diagonal() + i - j; exchanges let the upper band grow by `lower`
/// (J. Dongarra, J. Bunch, C. Moler, G. Stewart, LINPACK Users' Guide, SIAM 1979, chapter 2).
struct BandLayout {
  std::size_t size, lower, upper;
  std::size_t rows() const { return 2 * lower + upper + 1; }
  std::size_t diagonal() const { return lower + upper; }
};

/// The rows above the upper band must hold 0. Multipliers stay where they were made: unlike those of a whole
/// matrix they are not exchanged any more.
template <class Scalar>
void band_lu_factorize(const BandLayout& layout, Scalar* a, Scalar* reciprocal, std::size_t* row) {
  const std::size_t n = layout.size, stride = layout.rows() - 1;
  Scalar* const origin = a + layout.diagonal();  // (i, j) at origin[j * stride + i]
  std::size_t reach = 0;                         // the last column that a row above has entries in
  for (std::size_t k = 0; k < n; ++k) {
    const std::size_t last = std::min(n - 1, k + layout.lower);
    Scalar* const column = origin + k * stride;
    std::size_t pivot = k;
    auto largest = magnitude_of(column[k]);
    for (std::size_t i = k + 1; i <= last; ++i)
      if (const auto m = magnitude_of(column[i]); m > largest) pivot = i, largest = m;
    row[k] = pivot;
    reach = std::max(reach, std::min(n - 1, pivot + layout.upper));
    if (pivot != k)
      for (std::size_t j = k; j <= reach; ++j) std::swap(origin[j * stride + k], origin[j * stride + pivot]);
    reciprocal[k] = reciprocal_of(column[k]);
    for (std::size_t i = k + 1; i <= last; ++i) column[i] = column[i] * reciprocal[k];
    for (std::size_t j = k + 1; j <= reach; ++j) {
      Scalar* const other = origin + j * stride;
      const Scalar factor = other[k];
      for (std::size_t i = k + 1; i <= last; ++i) other[i] = other[i] - column[i] * factor;
    }
  }
}

template <class Scalar>
void band_lu_solve(const BandLayout& layout, const Scalar* a, const Scalar* reciprocal,
                   const std::size_t* row, Scalar* b) {
  const std::size_t n = layout.size, stride = layout.rows() - 1;
  const Scalar* const origin = a + layout.diagonal();
  for (std::size_t k = 0; k < n; ++k) {
    std::swap(b[k], b[row[k]]);
    const std::size_t last = std::min(n - 1, k + layout.lower);
    for (std::size_t i = k + 1; i <= last; ++i) b[i] = b[i] - origin[k * stride + i] * b[k];
  }
  for (std::size_t k = n; k-- > 0;) {
    b[k] = b[k] * reciprocal[k];
    for (std::size_t i = k > layout.diagonal() ? k - layout.diagonal() : 0; i < k; ++i)
      b[i] = b[i] - origin[k * stride + i] * b[k];
  }
}

}  // namespace odemark
