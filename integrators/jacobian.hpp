// df/dy at (t, y), in the shape that its system gives it: the problem's own, or forward differences where it
// has none.
#pragma once

#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "integrators/system.hpp"

namespace odemark {

/// The size to compile linear algebra for: that of a small array, else 0 for a size known at run time.
template <class S>
inline constexpr std::size_t inlined_size = fixed_size<S> <= 8 ? fixed_size<S> : 0;

/// All of the matrix unless the system says that it is banded.
template <System P>
MatrixShape jacobian_shape(const P& system, const typename P::State& model) {
  if constexpr (requires { system.jacobian_shape(); })
    return system.jacobian_shape();
  else
    return MatrixShape::dense(size_of(model));
}

/// Storage for a Jacobian; entries that nobody writes stay 0. N = 0: the size is known at run time.
template <class Real, std::size_t N = 0>
class JacobianMatrix {
 public:
  explicit JacobianMatrix(const MatrixShape&) {}
  static constexpr MatrixShape shape() { return MatrixShape::dense(N); }
  const Real* data() const { return entries_.data(); }
  MatrixView<Real> view() { return {entries_.data(), N}; }
  Real at(std::size_t row, std::size_t column) const { return entries_[column * N + row]; }

 private:
  std::array<Real, N * N> entries_{};
};

template <class Real>
class JacobianMatrix<Real, 0> {
 public:
  explicit JacobianMatrix(const MatrixShape& shape) : shape_(shape), entries_(shape.size * shape.rows()) {}
  const MatrixShape& shape() const { return shape_; }
  const Real* data() const { return entries_.data(); }
  MatrixView<Real> view() { return view_of(shape_, entries_.data()); }
  InterleavedView<Real> interleaved_view() { return interleaved_view_of(shape_, entries_.data()); }

  /// 0 outside of the band.
  Real at(std::size_t row, std::size_t column) const {
    if (shape_.is_dense()) return entries_[column * shape_.size + row];
    const std::size_t r = shape_.place(row), c = shape_.place(column);
    if (r > c + shape_.lower || c > r + shape_.upper) return Real(0);
    return entries_[c * shape_.rows() + shape_.upper + r - c];
  }
  /// out = J x
  void multiply(const Real* x, Real* out) const {
    for (std::size_t row = 0; row < shape_.size; ++row) {
      Real sum = 0;
      if (shape_.is_dense()) {
        for (std::size_t column = 0; column < shape_.size; ++column)
          sum += entries_[column * shape_.size + row] * x[column];
      } else {
        for_each_near(row, [&](std::size_t column) { sum += at(row, column) * x[column]; });
      }
      out[row] = sum;
    }
  }
  void clear() { entries_.assign(entries_.size(), Real(0)); }
  /// Adds a multiple of a matrix of the same shape.
  void add(Real factor, const JacobianMatrix& other) {
    for (std::size_t i = 0; i < entries_.size(); ++i) entries_[i] += factor * other.entries_[i];
  }

 private:
  /// f(column) for the columns of the band of a row.
  template <class F>
  void for_each_near(std::size_t row, F&& f) const {
    const std::size_t half = shape_.size / 2, r = shape_.place(row);
    for (std::size_t c = r > shape_.lower ? r - shape_.lower : 0; c <= r + shape_.upper && c < shape_.size;
         ++c)
      f(!shape_.interleaved ? c : c % 2 == 0 ? c / 2 : half + c / 2);
  }

  MatrixShape shape_;
  std::vector<Real> entries_;
};

/// The whole matrix. `base`, `shifted` and `moved` are scratch of the caller, so that a step allocates
/// nothing.
template <System P>
void evaluate_jacobian(const P& system, RealOf<typename P::State> t, const typename P::State& y,
                       MatrixView<RealOf<typename P::State>> j, typename P::State& base,
                       typename P::State& shifted, typename P::State& moved) {
  using Real = RealOf<typename P::State>;
  if constexpr (HasJacobian<P>) {
    system.jacobian(t, y, j);
  } else {
    system.rhs(t, y, base);
    moved = y;
    for (std::size_t column = 0; column < j.size; ++column) {
      const Real size = std::abs(y.data()[column]);
      const Real wished = std::sqrt(std::numeric_limits<Real>::epsilon()) * (size > 1 ? size : Real(1));
      moved.data()[column] = y.data()[column] + wished;
      const Real step = moved.data()[column] - y.data()[column];  // the step that was representable
      system.rhs(t, moved, shifted);
      for (std::size_t i = 0; i < j.size; ++i) j(i, column) = (shifted.data()[i] - base.data()[i]) / step;
      moved.data()[column] = y.data()[column];
    }
  }
}

/// In the shape of the system.
template <System P, std::size_t N>
void evaluate_jacobian(const P& system, RealOf<typename P::State> t, const typename P::State& y,
                       JacobianMatrix<RealOf<typename P::State>, N>& out, typename P::State& base,
                       typename P::State& shifted, typename P::State& moved) {
  if constexpr (requires { system.jacobian(t, y, out.interleaved_view()); })
    if (out.shape().interleaved) return system.jacobian(t, y, out.interleaved_view());
  evaluate_jacobian(system, t, y, out.view(), base, shifted, moved);
}

}  // namespace odemark
