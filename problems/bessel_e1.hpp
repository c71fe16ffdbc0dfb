// Bessel's equation of order one half: a non-autonomous oscillation that fades, with an elementary solution.
#pragma once
#include "problems/family.hpp"

namespace odemark {

/// State (y, y') at x = t + 1; the default start is that of the Bessel function J of order 1/2.
template <class Real = double>
struct BesselE1 {
  static constexpr std::string_view id = "bessel_e1";
  static constexpr std::string_view title = "Bessel's equation of order 1/2 (DETEST E1)";
  static constexpr std::string_view equations = "y'' = -y'/x - (1 - 1/(4 x^2)) y,  x = t + 1";
  static constexpr std::string_view source =
      "E1 of DETEST, T. E. Hull et al., SIAM J. Numer. Anal. 9 (1972) 603-637, doi:10.1137/0709052";
  static constexpr std::size_t size = 2;
  static constexpr std::array<Component, size> components{{{"y", ""}, {"y'", ""}}};
  static constexpr bool force_depends_on_velocity = true;

  Real y0 = Real(6713967071418030) / 10000000000000000, v0 = Real(954005144474744) / 10000000000000000,
       t_end = 20;

  static constexpr auto parameters() {
    using P = Parameter<BesselE1, Real>;
    return std::array{P{"y0", "", "initial y", &BesselE1::y0}, P{"v0", "", "initial y'", &BesselE1::v0},
                      P{"t_end", "", "end of the interval", &BesselE1::t_end, positive}};
  }
  static constexpr std::array presets{
      Preset{"bessel_e1", "y0=0.6713967071418030,v0=0.09540051444747446", "as published"},
      Preset{"bessel_e1_long", "y0=1,v0=0,t_end=100", "sixteen oscillations from a start without rounding"}};

  std::array<double, size> scale() const { return {1, 1}; }
  double suggested_dt() const { return 0.03125; }

  template <class T>
  void initial(T* y) const {
    y[0] = T(y0), y[1] = T(v0);
  }
  template <class T>
  void acceleration(const T& t, const T* y, T* a) const {
    const T x = t + 1;
    a[0] = -(y[1] / x) - (1 - 1 / (4 * x * x)) * y[0];
  }
  template <class T>
  void rhs(const T& t, const T* y, T* dydt) const {
    dydt[0] = y[1];
    acceleration(t, y, &dydt[1]);
  }
  template <class T, class J>
  void jacobian(const T& t, const T*, J&& j) const {
    const T x = t + 1;
    j(0, 0) = T(0), j(0, 1) = T(1);
    j(1, 0) = 1 / (4 * x * x) - 1, j(1, 1) = -1 / x;
  }
  /// The exact flow: y0 is the state at t = 0. sqrt(x) y is a harmonic oscillation.
  template <class T>
  void exact(const T& t, const T* start, T* y) const {
    using std::cos, std::sin, std::sqrt;
    const T x = t + 1, root = sqrt(x), c = cos(t), s = sin(t), slope = start[1] + start[0] / 2;
    const T u = start[0] * c + slope * s, du = slope * c - start[0] * s;
    y[0] = u / root;
    y[1] = (du - u / (2 * x)) / root;
  }
};

}  // namespace odemark
