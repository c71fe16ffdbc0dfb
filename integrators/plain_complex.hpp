// A complex number of two reals with the four operations of the textbook, the same bits in every build.
#pragma once

#include <cmath>

namespace odemark {

/// std::complex multiplies with a recovery from infinities that costs a branch; Newton matrices need none.
template <class Real>
struct PlainComplex {
  Real re{}, im{};

  friend constexpr PlainComplex operator+(const PlainComplex& a, const PlainComplex& b) {
    return {a.re + b.re, a.im + b.im};
  }
  friend constexpr PlainComplex operator-(const PlainComplex& a, const PlainComplex& b) {
    return {a.re - b.re, a.im - b.im};
  }
  friend constexpr PlainComplex operator*(const PlainComplex& a, const PlainComplex& b) {
    return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
  }
};

/// What pivots are compared by: |x|, or |re| + |im|.
template <class Real>
Real magnitude_of(const Real& x) {
  return std::abs(x);
}
template <class Real>
Real magnitude_of(const PlainComplex<Real>& x) {
  return std::abs(x.re) + std::abs(x.im);
}

template <class Real>
Real reciprocal_of(const Real& x) {
  return 1 / x;
}
/// Scaled first, so that the square of a number near the ends of the range does not overflow.
template <class Real>
PlainComplex<Real> reciprocal_of(const PlainComplex<Real>& x) {
  const Real scale = 1 / (std::abs(x.re) + std::abs(x.im));
  const Real re = x.re * scale, im = x.im * scale, factor = scale / (re * re + im * im);
  return {re * factor, -im * factor};
}

}  // namespace odemark
