// The slow oscillation of a glider between height and speed, after Lanchester.
#pragma once
#include <algorithm>

#include "problems/family.hpp"

namespace odemark {

/// State (x, h, V, gamma): lift in proportion to V^2, no drag. V0 is the speed of level flight.
template <class Real = double>
struct Phugoid {
  static constexpr std::string_view id = "phugoid";
  static constexpr std::string_view title = "Phugoid of an aeroplane";
  static constexpr std::string_view equations =
      "x' = V cos gamma;  h' = V sin gamma;  V' = -g sin gamma;  gamma' = g/V (V^2/V0^2 - cos gamma)";
  static constexpr std::string_view source =
      "F. W. Lanchester, Aerodonetics (Constable, 1908); R. von Mises, Theory of Flight (Dover, 1959)";
  static constexpr std::size_t size = 4;
  static constexpr std::array<Component, size> components{
      {{"x", "m"}, {"h", "m"}, {"V", "m/s"}, {"gamma", "rad"}}};
  static constexpr std::array<std::string_view, 2> invariant_names{"energy", "lanchester"};

  Real V0 = 50, g = Real(157) / 16, V = 65, gamma = Real(1) / 8, t_end = 60;

  static constexpr auto parameters() {
    using P = Parameter<Phugoid, Real>;
    return std::array{P{"V0", "m/s", "speed of steady level flight", &Phugoid::V0, positive},
                      P{"g", "m/s^2", "gravity", &Phugoid::g, positive},
                      P{"V", "m/s", "initial speed", &Phugoid::V, positive},
                      P{"gamma", "rad", "initial angle of climb", &Phugoid::gamma},
                      P{"t_end", "s", "end of the interval", &Phugoid::t_end, positive}};
  }
  static constexpr std::array presets{
      Preset{"phugoid", "", "waves of 60 m and 23 s"},
      Preset{"phugoid_small", "V=51,gamma=0", "nearly harmonic: the period is pi sqrt(2) V0/g, 22.6 s"},
      Preset{"phugoid_loop", "V=125,gamma=0,t_end=40", "fast enough to loop the loop"}};

  std::array<double, size> scale() const {
    const double v = std::max(double(V), double(V0)), height = v * v / (2 * double(g));
    return {v * double(t_end), height, v, 1};
  }
  double suggested_dt() const { return 0.03125 * double(V0) / double(g); }

  template <class T>
  void initial(T* y) const {
    y[0] = T(0), y[1] = T(0), y[2] = T(V), y[3] = T(gamma);
  }
  template <class T>
  void rhs(const T&, const T* y, T* dydt) const {
    using std::cos, std::sin;
    const T c = cos(y[3]), s = sin(y[3]);
    dydt[0] = y[2] * c;
    dydt[1] = y[2] * s;
    dydt[2] = -T(g) * s;
    dydt[3] = T(g) / (T(V0) * T(V0)) * y[2] - T(g) * c / y[2];
  }
  template <class T, class J>
  void jacobian(const T&, const T* y, J&& j) const {
    using std::cos, std::sin;
    const T c = cos(y[3]), s = sin(y[3]);
    for (std::size_t row = 0; row < size; ++row) j(row, 0) = T(0), j(row, 1) = T(0);
    j(0, 2) = c, j(0, 3) = -y[2] * s;
    j(1, 2) = s, j(1, 3) = y[2] * c;
    j(2, 2) = T(0), j(2, 3) = -T(g) * c;
    j(3, 2) = T(g) / (T(V0) * T(V0)) + T(g) * c / (y[2] * y[2]), j(3, 3) = T(g) * s / y[2];
  }
  /// Energy per mass; and V cos gamma - V^3/(3 V0^2), which draws Lanchester's curves.
  template <class T>
  void invariants(const T* y, T* out) const {
    using std::cos;
    out[0] = y[2] * y[2] / 2 + T(g) * y[1];
    out[1] = y[2] * (cos(y[3]) - y[2] * y[2] / (3 * T(V0) * T(V0)));
  }
};

}  // namespace odemark
