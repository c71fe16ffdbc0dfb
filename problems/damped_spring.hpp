// A mass on a spring with a viscous damper.
#pragma once
#include "problems/family.hpp"

namespace odemark {

/// State (x, v). Under-, critically and over-damped by zeta = c / (2 sqrt(k m)).
template <class Real = double>
struct DampedSpring {
  static constexpr std::string_view id = "damped_spring";
  static constexpr std::string_view title = "Damped spring and mass";
  static constexpr std::string_view equations = "x' = v;  v' = -(k/m) x - (c/m) v";
  static constexpr std::string_view source =
      "J. P. Den Hartog, Mechanical Vibrations, 4th ed. (McGraw-Hill, 1956), 2.7";
  static constexpr std::size_t size = 2;
  static constexpr std::array<Component, size> components{{{"x", "m"}, {"v", "m/s"}}};
  static constexpr bool force_depends_on_velocity = true;

  Real k = 1, m = 1, c = 0.25, x0 = 1, v0 = 0, t_end = 10;

  static constexpr auto parameters() {
    using P = Parameter<DampedSpring, Real>;
    return std::array{P{"k", "N/m", "spring stiffness", &DampedSpring::k, positive},
                      P{"m", "kg", "mass", &DampedSpring::m, positive},
                      P{"c", "N s/m", "viscous damping", &DampedSpring::c, not_negative},
                      P{"x0", "m", "initial displacement", &DampedSpring::x0},
                      P{"v0", "m/s", "initial velocity", &DampedSpring::v0},
                      P{"t_end", "s", "end of the interval", &DampedSpring::t_end, positive}};
  }
  static constexpr auto shorthands() {
    using S = Shorthand<DampedSpring, Real>;
    return std::array{S{"zeta", "", "damping ratio: sets c = 2 zeta sqrt(k m)",
                        [](DampedSpring& f, const Real& zeta) {
                          using std::sqrt;
                          f.c = 2 * zeta * sqrt(f.k * f.m);
                        },
                        not_negative}};
  }
  static constexpr std::array presets{
      Preset{"damped_spring", "", "under-damped, zeta = 1/8"},
      Preset{"damped_spring_critical", "zeta=1", "critically damped"},
      Preset{"damped_spring_overdamped", "zeta=2", "over-damped: two real rates, 14 to 1"}};

  /// Of the first swing.
  std::array<double, size> scale() const {
    const double w = std::sqrt(double(k) / double(m)), a = std::hypot(double(x0), double(v0) / w);
    return {a > 0 ? a : 1, a > 0 ? a * w : w};
  }
  double suggested_dt() const { return 0.05 / std::sqrt(double(k) / double(m)); }

  template <class T>
  void initial(T* y) const {
    y[0] = T(x0), y[1] = T(v0);
  }
  template <class T>
  void acceleration(const T&, const T* y, T* a) const {
    a[0] = -(T(k) / T(m)) * y[0] - (T(c) / T(m)) * y[1];
  }
  template <class T>
  void rhs(const T& t, const T* y, T* dydt) const {
    dydt[0] = y[1];
    acceleration(t, y, &dydt[1]);
  }
  template <class T, class J>
  void jacobian(const T&, const T*, J&& j) const {
    linear_part<T>(j);
  }
  template <class T, class L>
  void linear_part(L&& l) const {
    l(0, 0) = T(0), l(0, 1) = T(1);
    l(1, 0) = -(T(k) / T(m)), l(1, 1) = -(T(c) / T(m));
  }
  /// The same system with every drive removed: 0 is its fixed point.
  DampedSpring homogeneous() const { return *this; }

  /// The exact flow: y0 is the state at t = 0.
  template <class T>
  void exact(const T& t, const T* y0, T* y) const {
    using std::cos, std::cosh, std::exp, std::sin, std::sinh, std::sqrt;
    const T w2 = T(k) / T(m), d = T(c) / T(m) / 2, x = y0[0], v = y0[1];
    const T beyond = d * d - w2;
    if (beyond > 0) {  // two real rates; the slow one by the product of the roots, so nothing cancels
      const T fast = -(d + sqrt(beyond)), slow = w2 / fast;
      const T a = (v - fast * x) / (slow - fast), b = (slow * x - v) / (slow - fast);
      const T es = exp(slow * t), ef = exp(fast * t);
      y[0] = a * es + b * ef;
      y[1] = a * slow * es + b * fast * ef;
    } else {
      const T w = sqrt(-beyond), decay = exp(-d * t);
      const T s = w == 0 ? t : T(sin(w * t) / w), co = cos(w * t);
      y[0] = decay * (x * co + (v + d * x) * s);
      y[1] = decay * (v * co - (d * v + w2 * x) * s);
    }
  }
};

}  // namespace odemark
