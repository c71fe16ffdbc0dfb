#include "integrators/shifted_lu.hpp"

#include "integrators/band_lu.hpp"

namespace odemark {
namespace {

/// f with the size as a constant where it is small, so that its loops unroll.
template <class F>
void with_size(std::size_t size, const F& f) {
  switch (size) {
    case 1: return f(std::integral_constant<std::size_t, 1>{});
    case 2: return f(std::integral_constant<std::size_t, 2>{});
    case 3: return f(std::integral_constant<std::size_t, 3>{});
    case 4: return f(std::integral_constant<std::size_t, 4>{});
    case 8: return f(std::integral_constant<std::size_t, 8>{});
    default: return f(size);
  }
}

BandLayout layout_of(const MatrixShape& shape) { return {shape.size, shape.lower, shape.upper}; }

/// The band of f(jacobian), with zeros above it.
template <class Real, class Scalar, class F>
void fill_band(const JacobianMatrix<Real>& jacobian, std::vector<Scalar>& out, const F& f) {
  const MatrixShape& shape = jacobian.shape();
  const Real* from = jacobian.data();
  Scalar* to = out.data();
  for (std::size_t j = 0; j < shape.size; ++j) {
    for (std::size_t i = 0; i < shape.lower; ++i) *to++ = Scalar{};
    for (std::size_t i = 0; i < shape.rows(); ++i) *to++ = f(*from++);
  }
}
template <class Scalar>
void add_to_diagonal(const MatrixShape& shape, std::vector<Scalar>& band, const Scalar& shift) {
  const BandLayout layout = layout_of(shape);
  for (std::size_t k = 0; k < layout.size; ++k) {
    Scalar& entry = band[k * layout.rows() + layout.diagonal()];
    entry = shift + entry;
  }
}

}  // namespace

template <class Real, class Scalar>
ShiftedLu<Real, Scalar, 0>::ShiftedLu(const MatrixShape& shape)
    : shape_(shape),
      matrix_(shape.size * (shape.is_dense() ? shape.size : layout_of(shape).rows())),
      reciprocal_(shape.size),
      shuffled_(shape.interleaved ? shape.size : 0),
      row_(shape.size) {}

template <class Real, class Scalar>
void ShiftedLu<Real, Scalar, 0>::factorize_matrix() {
  band_lu_factorize(layout_of(shape_), matrix_.data(), reciprocal_.data(), row_.data());
}

template <class Real, class Scalar>
void ShiftedLu<Real, Scalar, 0>::factorize(const JacobianMatrix<Real>& jacobian, Scalar shift) {
  if (!shape_.is_dense()) {
    fill_band(jacobian, matrix_, [](Real x) { return Scalar{-x}; });
    add_to_diagonal(shape_, matrix_, shift);
    return factorize_matrix();
  }
  with_size(shape_.size, [&](auto n) {
    shift_matrix(jacobian.data(), shift, matrix_.data(), n);
    lu_factorize(matrix_.data(), reciprocal_.data(), row_.data(), n);
  });
}

template <class Real, class Scalar>
void ShiftedLu<Real, Scalar, 0>::factorize_step(const JacobianMatrix<Real>& jacobian, Scalar diagonal) {
  if (!shape_.is_dense()) {
    fill_band(jacobian, matrix_, [diagonal](Real x) { return Scalar{} - diagonal * Scalar{x}; });
    add_to_diagonal(shape_, matrix_, Scalar{Real(1)});
    return factorize_matrix();
  }
  with_size(shape_.size, [&](auto n) {
    step_matrix(jacobian.data(), diagonal, matrix_.data(), n);
    lu_factorize(matrix_.data(), reciprocal_.data(), row_.data(), n);
  });
}

template <class Real, class Scalar>
void ShiftedLu<Real, Scalar, 0>::solve_in_place(Scalar* b) {
  if (shape_.is_dense())
    return with_size(shape_.size,
                     [&](auto n) { lu_solve(matrix_.data(), reciprocal_.data(), row_.data(), b, n); });
  Scalar* x = b;
  if (shape_.interleaved) {
    x = shuffled_.data();
    for (std::size_t i = 0; i < shape_.size; ++i) x[shape_.place(i)] = b[i];
  }
  band_lu_solve(layout_of(shape_), matrix_.data(), reciprocal_.data(), row_.data(), x);
  if (shape_.interleaved)
    for (std::size_t i = 0; i < shape_.size; ++i) b[i] = x[shape_.place(i)];
}

template class ShiftedLu<float, float, 0>;
template class ShiftedLu<double, double, 0>;
template class ShiftedLu<long double, long double, 0>;
template class ShiftedLu<float, PlainComplex<float>, 0>;
template class ShiftedLu<double, PlainComplex<double>, 0>;
template class ShiftedLu<long double, PlainComplex<long double>, 0>;

}  // namespace odemark
