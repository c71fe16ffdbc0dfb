// The undamped spring: what explicit Euler blows up on.
#pragma once
#include "problems/family.hpp"

namespace odemark {

/// State (x, v), angular frequency w = sqrt(k/m).
template <class Real = double>
struct Oscillator {
  static constexpr std::string_view id = "oscillator";
  static constexpr std::string_view title = "Undamped spring and mass";
  static constexpr std::string_view equations = "x' = v;  v' = -(k/m) x";
  static constexpr std::string_view source =
      "E. Hairer, C. Lubich, G. Wanner, Geometric Numerical Integration, 2nd ed. (Springer, 2006), I.1";
  static constexpr std::size_t size = 2;
  static constexpr std::array<Component, size> components{{{"x", "m"}, {"v", "m/s"}}};
  static constexpr std::array<std::string_view, 1> invariant_names{"energy"};
  static constexpr bool force_depends_on_velocity = false;

  Real k = 1, m = 1, x0 = 1, v0 = 0, t_end = 10;

  static constexpr auto parameters() {
    using P = Parameter<Oscillator, Real>;
    return std::array{P{"k", "N/m", "spring stiffness", &Oscillator::k, positive},
                      P{"m", "kg", "mass", &Oscillator::m, positive},
                      P{"x0", "m", "initial displacement", &Oscillator::x0},
                      P{"v0", "m/s", "initial velocity", &Oscillator::v0},
                      P{"t_end", "s", "end of the interval", &Oscillator::t_end, positive}};
  }
  static constexpr auto shorthands() {
    using S = Shorthand<Oscillator, Real>;
    return std::array{S{"omega", "rad/s", "angular frequency: sets k = m omega^2",
                        [](Oscillator& f, const Real& omega) { f.k = f.m * omega * omega; }, positive}};
  }
  static constexpr std::array presets{
      Preset{"oscillator", "", "1 rad/s over 10 s: the end is no multiple of the period"}};

  std::array<double, size> scale() const {
    const double w = std::sqrt(double(k) / double(m)), a = std::hypot(double(x0), double(v0) / w);
    return {a, a * w};
  }
  double suggested_dt() const { return 0.05 / std::sqrt(double(k) / double(m)); }

  template <class T>
  void initial(T* y) const {
    y[0] = T(x0), y[1] = T(v0);
  }
  template <class T>
  void acceleration(const T&, const T* y, T* a) const {
    a[0] = -(T(k) / T(m)) * y[0];
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
    l(1, 0) = -(T(k) / T(m)), l(1, 1) = T(0);
  }
  /// The same system with every drive removed: 0 is its fixed point.
  Oscillator homogeneous() const { return *this; }

  /// The exact flow: y0 is the state at t = 0.
  template <class T>
  void exact(const T& t, const T* y0, T* y) const {
    using std::cos, std::sin, std::sqrt;
    const T w = sqrt(T(k) / T(m)), c = cos(w * t), s = sin(w * t);
    y[0] = y0[0] * c + y0[1] / w * s;
    y[1] = y0[1] * c - y0[0] * w * s;
  }
  template <class T>
  void invariants(const T* y, T* out) const {
    out[0] = (T(m) * y[1] * y[1] + T(k) * y[0] * y[0]) / 2;
  }
  Oscillation oscillation(const double* y) const {
    const double w = std::sqrt(double(k) / double(m));
    return {std::hypot(y[0], y[1] / w), std::atan2(-y[1] / w, y[0]), w};
  }
};

}  // namespace odemark
