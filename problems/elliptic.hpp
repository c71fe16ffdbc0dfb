// Jacobi's elliptic functions and the elliptic integrals, to the last digit of any ordered number type. The
// modulus enters by its complement kc = sqrt(1 - k^2), which stays meaningful beside a separatrix, where k
// rounds to 1.
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
  while (abs(a[level] - g[level]) > sqrt(std::numeric_limits<T>::epsilon()) * a[level] / 16 &&
         level + 1 < a.size()) {
    a[level + 1] = (a[level] + g[level]) / 2;
    g[level + 1] = sqrt(a[level] * g[level]);
    ++level;
  }
  const T mean = (a[level] + g[level]) / 2, s = sin(mean * u), c = cos(mean * u);
  if (s == 0) return {s, c, T(1)};
  T cs = mean * (c / s), dn = 1, above = mean;  // cs becomes cn/sn
  for (std::size_t i = level + 1; i-- > 0;) {
    const T x = cs * cs / above;
    cs *= dn;
    dn = (g[i] + x) / (a[i] + x);
    above = a[i];
  }
  const T sn = (s < 0 ? -1 : 1) / sqrt(cs * cs + 1);
  return {sn, cs * sn, dn};
}

/// Carlson's symmetric integral of the first kind, all arguments >= 0 and at most one of them 0:
/// B. C. Carlson, Numer. Algorithms 10 (1995) 13-26, doi:10.1007/BF02198293.
template <class T>
T carlson_rf(T x, T y, T z) {
  using std::abs, std::sqrt;
  for (;;) {
    const T mean = (x + y + z) / 3, u = 1 - x / mean, v = 1 - y / mean, w = -u - v;
    const T d = std::max(abs(u), abs(v)), d2 = d * d;
    if (!(d2 * d2 * d2 > std::numeric_limits<T>::epsilon())) {
      const T e2 = u * v - w * w, e3 = u * v * w;
      return (1 - e2 / 10 + e3 / 14 + e2 * e2 / 24 - 3 * e2 * e3 / 44) / sqrt(mean);
    }
    const T shift = sqrt(x * y) + sqrt(x * z) + sqrt(y * z);
    x = (x + shift) / 4, y = (y + shift) / 4, z = (z + shift) / 4;
  }
}

/// Carlson's symmetric integral of the third kind for p >= x, y, z >= 0: the same paper.
template <class T>
T carlson_rj(T x, T y, T z, T p) {
  using std::abs, std::atan, std::sqrt;
  T sum = 0, scale = 1;
  for (;;) {
    const T mean = (x + y + z + 2 * p) / 5;
    const T u = 1 - x / mean, v = 1 - y / mean, w = 1 - z / mean, q = -(u + v + w) / 2;
    const T d = std::max({T(abs(u)), T(abs(v)), T(abs(w)), T(abs(q))}), d2 = d * d;
    if (!(d2 * d2 * d2 > std::numeric_limits<T>::epsilon())) {
      const T uvw = u * v * w, e2 = u * v + u * w + v * w - 3 * q * q, e3 = uvw + 2 * e2 * q + 4 * q * q * q;
      const T e4 = (2 * uvw + e2 * q + 3 * q * q * q) * q, e5 = uvw * q * q;
      const T series =
          1 - 3 * e2 / 14 + e3 / 6 + 9 * e2 * e2 / 88 - 3 * e4 / 22 - 9 * e2 * e3 / 52 + 3 * e5 / 26;
      return sum + scale * series / (mean * sqrt(mean));
    }
    const T rx = sqrt(x), ry = sqrt(y), rz = sqrt(z), rp = sqrt(p), shift = rx * ry + rx * rz + ry * rz;
    const T width = (rp + rx) * (rp + ry) * (rp + rz);
    const T root = sqrt((p - x) * (p - y) * (p - z)) / width;  // R_C(1, 1 + root^2) = atan(root)/root
    sum += 6 * scale / width * (root == 0 ? T(1) : T(atan(root) / root));
    x = (x + shift) / 4, y = (y + shift) / 4, z = (z + shift) / 4, p = (p + shift) / 4;
    scale /= 4;
  }
}

/// Legendre's integral of the first kind up to an angle in [-pi/2, pi/2], told by its sn, cn and dn.
template <class T>
T first_kind(const Jacobi<T>& at) {
  return at.sn * carlson_rf<T>(at.cn * at.cn, at.dn * at.dn, 1);
}

/// Legendre's integral of the third kind, the integral of du / (1 + n sn^2 u), for n >= 0.
template <class T>
T third_kind(const T& n, const Jacobi<T>& at) {
  const T c2 = at.cn * at.cn, d2 = at.dn * at.dn, s2 = at.sn * at.sn;
  return at.sn * (carlson_rf<T>(c2, d2, 1) - n / 3 * s2 * carlson_rj<T>(c2, d2, 1, 1 + n * s2));
}

}  // namespace odemark::elliptic
