// Jacobi's elliptic functions and the elliptic integrals, to the last digit of any ordered number type. The modulus
// enters by its complement kc = sqrt(1 - k^2), which stays meaningful beside a separatrix, where k rounds to 1.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace odemark::elliptic {

template <class T>
T pi() {
  using std::atan;
  return 4 * atan(T(1));
}

/// The nearest whole number, as a T.
template <class T>
T nearest(const T& x) {
  using std::floor;
  return floor(x + T(1) / 2);
}

/// The quarter period K by the arithmetic-geometric mean; infinite for kc = 0.
template <class T>
T quarter_period(const T& kc) {
  using std::abs, std::sqrt;
  if (kc == 0) return std::numeric_limits<T>::infinity();
  T a = 1, g = kc;
  while (abs(a - g) > 4 * std::numeric_limits<T>::epsilon() * a) {
    const T mean = (a + g) / 2;
    g = sqrt(a * g), a = mean;
  }
  return pi<T>() / (a + g);
}

template <class T>
struct Jacobi {
  T sn, cn, dn;
};

/// sn, cn and dn of u by descending Landen transformations: R. Bulirsch, Numer. Math. 7 (1965) 78-90,
/// doi:10.1007/BF01397975, procedure sncndn.
template <class T>
Jacobi<T> jacobi(const T& u, const T& kc) {
  using std::abs, std::cos, std::cosh, std::sin, std::sqrt, std::tanh;
  if (kc == 0) return {tanh(u), 1 / cosh(u), 1 / cosh(u)};
  std::array<T, 40> a, g;  // converges quadratically: 16 levels are enough for kc = 1e-300 and 50 digits
  std::size_t level = 0;
  a[0] = 1, g[0] = kc;
  while (abs(a[level] - g[level]) > sqrt(std::numeric_limits<T>::epsilon()) * a[level] / 16 && level + 1 < a.size()) {
    a[level + 1] = (a[level] + g[level]) / 2;
    g[level + 1] = sqrt(a[level] * g[level]);
    ++level;
  }
  const T mean = (a[level] + g[level]) / 2, s = sin(mean * u), c = cos(mean * u);
  if (s == 0) return {s, c, T(1)};
  T cs = mean * (c / s), dn = 1;  // a cn/sn of this level
  for (std::size_t i = level + 1; i-- > 0;) {
    const T x = cs * cs / a[i];
    cs *= dn;
    dn = (g[i] + x) / (a[i] + x);
  }
  const T sn = (s < 0 ? -1 : 1) / sqrt(cs * cs + 1);
  return {sn, cs * sn, dn};
}

}  // namespace odemark::elliptic
