// A root between two points of different sign, to the last bits: T. R. Chandrupatla, Adv. Eng. Softw. 28
// (1997) 145-149, doi:10.1016/S0965-9978(96)00051-8.
#pragma once

namespace odemark {

/// Shrinks [above, behind] with f(above) > 0 >= f(behind) until it is no longer than `width` or f is 0,
/// and returns the end at which f is not positive. Inverse quadratic interpolation where three values lie
/// well, bisection elsewhere, so that the length at least halves every few evaluations. `f` takes the side of
/// the root by `> 0`: NaN counts as behind it.
template <class T, class F>
T bracket_root(T above, T f_above, T behind, T f_behind, const T& width, F&& f, int most = 200) {
  const auto size = [](const T& x) { return x < 0 ? T(-x) : x; };
  T x1 = behind, f1 = f_behind, x2 = above, f2 = f_above, x3 = x2, f3 = f2;
  T share = f1 / (f1 - f2);
  for (int i = 0; i < most && f1 != 0 && f2 != 0; ++i) {
    const T length = size(x2 - x1), least = width / 2 / length;
    if (!(length > width)) break;
    if (!(share > least)) share = least;
    if (!(share < 1 - least)) share = 1 - least;
    T x = x1 + share * (x2 - x1);
    if (x == x1 || x == x2) break;
    const T value = f(x);
    if ((value > 0) == (f1 > 0))
      x3 = x1, f3 = f1;
    else
      x3 = x2, f3 = f2, x2 = x1, f2 = f1;
    x1 = x, f1 = value;
    const T xi = (x1 - x2) / (x3 - x2), phi = (f1 - f2) / (f3 - f2);
    share = T(1) / 2;
    if (phi * phi < xi && (1 - phi) * (1 - phi) < 1 - xi)
      share = f1 / (f2 - f1) * (f3 / (f2 - f3)) + (x3 - x1) / (x2 - x1) * (f1 / (f3 - f1)) * (f2 / (f3 - f2));
  }
  return f1 > 0 ? x2 : x1;
}

}  // namespace odemark
