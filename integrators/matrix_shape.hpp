// Which entries of a Jacobian may differ from zero, and where they are stored.
#pragma once

#include <cstddef>

namespace odemark {

/// Square, column-major view that a problem writes its Jacobian into: J(row, column) = df_row/dy_column.
/// `stride` numbers lie between columns: all of a matrix or, one less than those stored, its band.
template <class Real>
struct MatrixView {
  Real* data;
  std::size_t size;
  std::size_t stride = size;
  Real& operator()(std::size_t row, std::size_t column) const { return data[column * stride + row]; }
};

/// The same for the band of a second-order system, whose positions and velocities are stored in turn.
template <class Real>
struct InterleavedView {
  Real* data;
  std::size_t size, stride;
  std::size_t place(std::size_t i) const { return i < size / 2 ? 2 * i : 2 * (i - size / 2) + 1; }
  Real& operator()(std::size_t row, std::size_t column) const {
    return data[place(column) * stride + place(row)];
  }
};

/// Entries lie at most `lower` places below the diagonal and `upper` above it. `interleaved`: once rows and
/// columns are taken in the order x1, v1, x2, v2, ... instead of all positions first.
struct MatrixShape {
  std::size_t size = 0, lower = 0, upper = 0;
  bool interleaved = false;

  static constexpr MatrixShape dense(std::size_t size) { return {size, size, size}; }
  /// The band where it saves memory, else the whole matrix.
  static constexpr MatrixShape band(std::size_t size, std::size_t lower, std::size_t upper,
                                    bool interleaved) {
    return lower + upper + 1 < size ? MatrixShape{size, lower, upper, interleaved} : dense(size);
  }
  constexpr bool is_dense() const { return lower + upper + 1 >= size; }
  /// Numbers stored for a column.
  constexpr std::size_t rows() const { return is_dense() ? size : lower + upper + 1; }
  constexpr std::size_t place(std::size_t i) const {
    if (!interleaved) return i;
    return i < size / 2 ? 2 * i : 2 * (i - size / 2) + 1;
  }
  /// The shape of the blocks da/dx and da/dv of a second-order system.
  constexpr MatrixShape block() const {
    return is_dense() ? dense(size / 2) : band(size / 2, lower / 2, (upper + 1) / 2, false);
  }
};

/// Views of storage for that shape; a band's numbers begin with its highest diagonal.
template <class Real>
MatrixView<Real> view_of(const MatrixShape& shape, Real* data) {
  if (shape.is_dense()) return {data, shape.size};
  return {data + shape.upper, shape.size, shape.rows() - 1};
}
template <class Real>
InterleavedView<Real> interleaved_view_of(const MatrixShape& shape, Real* data) {
  return {data + shape.upper, shape.size, shape.rows() - 1};
}

}  // namespace odemark
