// Dual numbers: a right-hand side run on them gives its exact Jacobian.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

namespace odemark {

/// value + sum_i partial[i] d_i with d_i d_j = 0 (forward-mode automatic differentiation).
template <class T, std::size_t N>
struct Dual {
  T value{};
  std::array<T, N> partial{};

  Dual() = default;
  Dual(const T& v) : value(v) {}
  template <class U>
  requires(std::is_arithmetic_v<U> && !std::is_same_v<U, T>) explicit(!std::is_integral_v<U>) Dual(U v)
      : value(static_cast<T>(v)) {}

  /// The i-th independent variable.
  static Dual variable(const T& v, std::size_t i) {
    Dual x(v);
    x.partial[i] = T(1);
    return x;
  }
  /// f(x) from f and f' at its value.
  Dual chain(const T& f, const T& slope) const {
    Dual r(f);
    for (std::size_t i = 0; i < N; ++i) r.partial[i] = slope * partial[i];
    return r;
  }

  Dual operator-() const { return chain(-value, T(-1)); }
  Dual& operator+=(const Dual& o) { return *this = *this + o; }
  Dual& operator-=(const Dual& o) { return *this = *this - o; }
  Dual& operator*=(const Dual& o) { return *this = *this * o; }
  Dual& operator/=(const Dual& o) { return *this = *this / o; }

  friend Dual operator+(const Dual& a, const Dual& b) {
    Dual r(a.value + b.value);
    for (std::size_t i = 0; i < N; ++i) r.partial[i] = a.partial[i] + b.partial[i];
    return r;
  }
  friend Dual operator-(const Dual& a, const Dual& b) {
    Dual r(a.value - b.value);
    for (std::size_t i = 0; i < N; ++i) r.partial[i] = a.partial[i] - b.partial[i];
    return r;
  }
  friend Dual operator*(const Dual& a, const Dual& b) {
    Dual r(a.value * b.value);
    for (std::size_t i = 0; i < N; ++i) r.partial[i] = a.partial[i] * b.value + a.value * b.partial[i];
    return r;
  }
  friend Dual operator/(const Dual& a, const Dual& b) {
    Dual r(a.value / b.value);
    for (std::size_t i = 0; i < N; ++i) r.partial[i] = (a.partial[i] - r.value * b.partial[i]) / b.value;
    return r;
  }
  friend bool operator<(const Dual& a, const Dual& b) { return a.value < b.value; }
  friend bool operator>(const Dual& a, const Dual& b) { return a.value > b.value; }
  friend bool operator==(const Dual& a, const Dual& b) { return a.value == b.value; }

  friend Dual sqrt(const Dual& x) {
    using std::sqrt;
    const T root = sqrt(x.value);
    return x.chain(root, T(1) / (2 * root));
  }
  friend Dual exp(const Dual& x) {
    using std::exp;
    const T e = exp(x.value);
    return x.chain(e, e);
  }
  friend Dual log(const Dual& x) {
    using std::log;
    return x.chain(log(x.value), T(1) / x.value);
  }
  friend Dual sin(const Dual& x) {
    using std::cos, std::sin;
    return x.chain(sin(x.value), cos(x.value));
  }
  friend Dual cos(const Dual& x) {
    using std::cos, std::sin;
    return x.chain(cos(x.value), -sin(x.value));
  }
  friend Dual sinh(const Dual& x) {
    using std::cosh, std::sinh;
    return x.chain(sinh(x.value), cosh(x.value));
  }
  friend Dual cosh(const Dual& x) {
    using std::cosh, std::sinh;
    return x.chain(cosh(x.value), sinh(x.value));
  }
  friend Dual tanh(const Dual& x) {
    using std::cosh, std::tanh;
    const T c = cosh(x.value);  // 1 - tanh^2 would lose its digits where tanh is near 1
    return x.chain(tanh(x.value), T(1) / c / c);
  }
  friend Dual atan(const Dual& x) {
    using std::atan;
    return x.chain(atan(x.value), T(1) / (1 + x.value * x.value));
  }
  /// x^p for a constant p, whatever p's derivatives.
  friend Dual pow(const Dual& x, const Dual& p) {
    using std::pow;
    return x.chain(pow(x.value, p.value), p.value * pow(x.value, p.value - 1));
  }
  friend Dual abs(const Dual& x) { return x.value < 0 ? -x : x; }
};

}  // namespace odemark
