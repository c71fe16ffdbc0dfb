// A stiff spring and damper dragged along by a slow drive: the contact or suspension of a real-time scene.
#pragma once
#include <algorithm>
#include <string>

#include "problems/damped_spring.hpp"
#include "problems/family.hpp"

namespace odemark {

/// State (x, v). The far end of spring and damper moves as amplitude sin(omega t), and the mass follows it
/// closely, whatever the stiffness: a sweep over k changes the fast rates and nothing else. The start at rest
/// misses the speed of the drive by amplitude omega, which excites the fast rates.
template <class Real = double>
struct StiffSpring {
  static constexpr std::string_view id = "stiff_spring";
  static constexpr std::string_view title = "Stiff spring and damper under a slow drive";
  static constexpr std::string_view equations =
      "x' = v;  v' = -(k/m) (x - amplitude sin(omega t)) - (c/m) (v - amplitude omega cos(omega t))";
  static constexpr std::string_view source =
      "J. P. Den Hartog, Mechanical Vibrations, 4th ed. (McGraw-Hill, 1956), 2.8";
  static constexpr std::size_t size = 2;
  static constexpr std::array<Component, size> components{{{"x", "m"}, {"v", "m/s"}}};
  static constexpr bool force_depends_on_velocity = true;

  Real k = 1000000, m = 1, c = 500, amplitude = 1, omega = 1, x0 = 0, v0 = 0, t_end = 10;

  static constexpr auto parameters() {
    using P = Parameter<StiffSpring, Real>;
    return std::array{
        P{"k", "N/m", "spring stiffness", &StiffSpring::k, positive},
        P{"m", "kg", "mass", &StiffSpring::m, positive},
        P{"c", "N s/m", "viscous damping", &StiffSpring::c, not_negative},
        P{"amplitude", "m", "amplitude of the drive", &StiffSpring::amplitude},
        P{"omega", "rad/s", "angular frequency of the drive", &StiffSpring::omega, not_negative},
        P{"x0", "m", "initial position", &StiffSpring::x0},
        P{"v0", "m/s", "initial velocity", &StiffSpring::v0},
        P{"t_end", "s", "end of the interval", &StiffSpring::t_end, positive}};
  }
  static constexpr auto shorthands() {
    using S = Shorthand<StiffSpring, Real>;
    return std::array{S{"zeta", "", "damping ratio: sets c = 2 zeta sqrt(k m)",
                        [](StiffSpring& f, const Real& zeta) {
                          using std::sqrt;
                          f.c = 2 * zeta * sqrt(f.k * f.m);
                        },
                        not_negative}};
  }
  static constexpr std::array presets{
      Preset{"stiff_spring", "", "zeta = 1/4: rates -250 +- 968 i"},
      Preset{"stiff_spring_k1e4", "k=1e4,c=50", "zeta = 1/4, 100 rad/s"},
      Preset{"stiff_spring_k1e5", "k=1e5,c=160", "zeta = 0.253, 316 rad/s"},
      Preset{"stiff_spring_k1e7", "k=1e7,c=1600", "zeta = 0.253, 3162 rad/s"},
      Preset{"stiff_spring_k1e8", "k=1e8,c=5000", "zeta = 1/4, 10000 rad/s"},
      Preset{"stiff_spring_undamped", "c=0", "the fast oscillation never dies: 1000 rad/s, amplitude 1 mm"},
      Preset{"stiff_spring_critical", "c=2000", "zeta = 1: the rate -1000 twice"},
      Preset{"stiff_spring_overdamped", "c=8000", "zeta = 4: rates -127 and -7873"}};

  std::string validate() const {
    return c == 0 && amplitude != 0 && k == m * omega * omega
               ? "an undamped spring must not be driven at its own frequency: k = m omega^2 needs c > 0"
               : "";
  }
  std::array<double, size> scale() const {
    const double x = std::max(std::abs(double(amplitude)), std::abs(double(x0)));
    const double v = std::max(std::abs(double(amplitude)) * double(omega), std::abs(double(v0)));
    return {x > 0 ? x : 1, v > 0 ? v : 1};
  }
  double suggested_dt() const {
    const double w = std::sqrt(double(k) / double(m)), d = double(c) / double(m) / 2;
    return 0.05 / (d > w ? d + std::sqrt(d * d - w * w) : w);
  }

  template <class T>
  void initial(T* y) const {
    y[0] = T(x0), y[1] = T(v0);
  }
  template <class T>
  void acceleration(const T& t, const T* y, T* a) const {
    using std::cos, std::sin;
    const T angle = T(omega) * t;
    a[0] = -(T(k) / T(m)) * (y[0] - T(amplitude) * sin(angle)) -
           (T(c) / T(m)) * (y[1] - T(amplitude) * T(omega) * cos(angle));
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
  StiffSpring homogeneous() const {
    StiffSpring undriven = *this;
    undriven.amplitude = 0;
    return undriven;
  }

  /// The exact flow: y0 is the state at t = 0. The lag z = x - amplitude sin(omega t) obeys
  /// z'' + (c/m) z' + (k/m) z = amplitude omega^2 sin(omega t): a steady lag and a free damped spring.
  template <class T>
  void exact(const T& t, const T* y0, T* y) const {
    using std::cos, std::sin;
    const T w = T(omega), a = T(amplitude), s = sin(w * t), co = cos(w * t);
    const T detuning = T(k) / T(m) - w * w, friction = T(c) / T(m) * w;
    const T size2 = detuning * detuning + friction * friction;
    const T p = a == 0 ? a : T(a * w * w * detuning / size2),
            q = a == 0 ? a : T(-a * w * w * friction / size2);
    const T start[2] = {y0[0] - q, y0[1] - (a + p) * w};
    DampedSpring<Real> spring;
    spring.k = k, spring.m = m, spring.c = c;
    spring.exact(t, start, y);
    y[0] += (a + p) * s + q * co;
    y[1] += ((a + p) * co - q * s) * w;
  }
};

}  // namespace odemark
