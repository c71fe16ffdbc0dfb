// Two linear equations with constant coefficients, solved: what half of the closed forms here rest on.
#pragma once
#include <cmath>

namespace odemark {

/// z' = A z. With apart = (A - d)/2 in the corners, the roots are mean +- sqrt(apart^2 + a01 a10).
template <class T>
struct PlaneFlow {
  T a00, a01, a10, a11;

  T determinant() const { return a00 * a11 - a01 * a10; }

  /// z(t) from z0; the two may be the same.
  void operator()(const T& t, const T* z0, T* z) const {
    using std::cos, std::exp, std::sin, std::sqrt;
    const T mean = (a00 + a11) / 2, apart = (a00 - a11) / 2, square = apart * apart + a01 * a10;
    const T x = z0[0], y = z0[1], dx = apart * x + a01 * y, dy = a10 * x - apart * y;  // (A - mean) z0
    if (square > 0) {  // the slow root by the product of the roots, so that nothing cancels
      const T fast = mean < 0 ? T(mean - sqrt(square)) : T(mean + sqrt(square)), slow = determinant() / fast;
      const T half = (slow - fast) / 2, ef = exp(fast * t), es = exp(slow * t);
      z[0] = ((es + ef) * x + (es - ef) / half * dx) / 2;
      z[1] = ((es + ef) * y + (es - ef) / half * dy) / 2;
    } else {
      const T w = sqrt(-square), decay = exp(mean * t);
      const T c = cos(w * t), s = w == 0 ? t : T(sin(w * t) / w);
      z[0] = decay * (c * x + s * dx);
      z[1] = decay * (c * y + s * dy);
    }
  }

  /// The integral of z over (0, t) is A^-1 (z(t) - z0), for an invertible A.
  void integral(const T* change, T* sum) const {
    const T below = determinant(), x = change[0], y = change[1];
    sum[0] = (a11 * x - a01 * y) / below;
    sum[1] = (a00 * y - a10 * x) / below;
  }
};

}  // namespace odemark
