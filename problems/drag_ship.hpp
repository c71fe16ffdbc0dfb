// The ship of the textbook chapter: constant thrust against a drag that grows with the speed.
#pragma once
#include <algorithm>

#include "problems/family.hpp"

namespace odemark {

/// State (s, v). The defaults have the chapter's T/C = 20 m/s and C/m = 0.1 1/s. The speed settles at thrust
/// / drag with the rate drag / m.
template <class Real = double>
struct DragShip {
  static constexpr std::string_view id = "drag_ship";
  static constexpr std::string_view title = "Ship with linear drag";
  static constexpr std::string_view equations = "s' = v;  v' = thrust/m - (drag/m) v";
  static constexpr std::string_view source =
      "D. M. Bourg, B. Bywalec, Physics for Game Developers, 2nd ed. (O'Reilly, 2013), chapter 7, Table 7-1";
  static constexpr std::size_t size = 2;
  static constexpr std::array<Component, size> components{{{"s", "m"}, {"v", "m/s"}}};
  static constexpr bool force_depends_on_velocity = true;

  Real thrust = 20000, drag = 1000, m = 10000, s0 = 0, v0 = 0, t_end = 60;

  static constexpr auto parameters() {
    using P = Parameter<DragShip, Real>;
    return std::array{P{"thrust", "N", "propeller thrust, T", &DragShip::thrust},
                      P{"drag", "kg/s", "drag coefficient, C", &DragShip::drag, not_negative},
                      P{"m", "kg", "mass", &DragShip::m, positive},
                      P{"s0", "m", "initial position", &DragShip::s0},
                      P{"v0", "m/s", "initial speed", &DragShip::v0},
                      P{"t_end", "s", "end of the interval", &DragShip::t_end, positive}};
  }
  static constexpr std::array presets{
      Preset{"drag_ship", "", "from rest towards 20 m/s, time constant 10 s"}};

  std::array<double, size> scale() const {
    const double limit =
        std::min(double(m) / double(drag), double(t_end));  // m / 0 is infinite, and never chosen
    const double v = std::max(std::abs(double(v0)), std::abs(double(thrust)) / double(m) * limit);
    return v > 0 ? std::array<double, size>{v * double(t_end), v} : std::array<double, size>{1, 1};
  }
  double suggested_dt() const { return 0.5; }

  template <class T>
  void initial(T* y) const {
    y[0] = T(s0), y[1] = T(v0);
  }
  template <class T>
  void acceleration(const T&, const T* y, T* a) const {
    a[0] = T(thrust) / T(m) - (T(drag) / T(m)) * y[1];
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
    l(1, 0) = T(0), l(1, 1) = -(T(drag) / T(m));
  }
  /// The same system with every drive removed: 0 is its fixed point.
  DragShip homogeneous() const {
    DragShip adrift = *this;
    adrift.thrust = 0;
    return adrift;
  }

  /// The exact flow: y0 is the state at t = 0. With z = rate t it is made of e^-z, of (1 - e^-z)/z and of
  /// (z - 1 + e^-z)/z^2, each formed without cancellation, so that a ship without drag is no special case.
  template <class T>
  void exact(const T& t, const T* y0, T* y) const {
    using std::abs, std::exp, std::expm1;
    const T rate = T(drag) / T(m), push = T(thrust) / T(m), z = rate * t;
    const T once = z == 0 ? t : T(-expm1(-z) / rate);
    T twice = (t - once) / rate;
    if (abs(z) < 1) {  // t^2 (1/2! - z/3! + z^2/4! - ...)
      T term = t * t / 2;
      twice = term;
      for (int k = 3; abs(term) > abs(twice) * std::numeric_limits<T>::epsilon() / 4; ++k)
        term *= -z / T(k), twice += term;
    }
    y[0] = y0[0] + y0[1] * once + push * twice;
    y[1] = y0[1] * exp(-z) + push * once;
  }
};

}  // namespace odemark
