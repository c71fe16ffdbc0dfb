#include "integrators/shifted_lu.hpp"

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

}  // namespace

template <class Real, class Scalar>
ShiftedLu<Real, Scalar, 0>::ShiftedLu(std::size_t size)
    : size_(size), matrix_(size * size), reciprocal_(size), row_(size) {}

template <class Real, class Scalar>
void ShiftedLu<Real, Scalar, 0>::factorize(const Real* jacobian, Scalar shift) {
  with_size(size_, [&](auto n) {
    shift_matrix(jacobian, shift, matrix_.data(), n);
    lu_factorize(matrix_.data(), reciprocal_.data(), row_.data(), n);
  });
}

template <class Real, class Scalar>
void ShiftedLu<Real, Scalar, 0>::solve_in_place(Scalar* b) const {
  with_size(size_, [&](auto n) { lu_solve(matrix_.data(), reciprocal_.data(), row_.data(), b, n); });
}

template class ShiftedLu<float, float, 0>;
template class ShiftedLu<double, double, 0>;
template class ShiftedLu<long double, long double, 0>;
template class ShiftedLu<float, PlainComplex<float>, 0>;
template class ShiftedLu<double, PlainComplex<double>, 0>;
template class ShiftedLu<long double, PlainComplex<long double>, 0>;

}  // namespace odemark
