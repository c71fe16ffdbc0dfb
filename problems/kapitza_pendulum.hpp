// A pendulum that stands upside down because its pivot shakes.
#pragma once
#include <algorithm>

#include "problems/family.hpp"

namespace odemark {

/// State (angle from upright, its rate). The pivot moves by a cos W t; upright is stable for a W > sqrt(2 g
/// L).
template <class Real = double>
struct KapitzaPendulum {
  static constexpr std::string_view id = "kapitza_pendulum";
  static constexpr std::string_view title = "Kapitza's pendulum";
  static constexpr std::string_view equations = "phi' = w;  w' = (g - a W^2 cos W t)/L sin phi";
  static constexpr std::string_view source =
      "P. L. Kapitza, Zh. Eksp. Teor. Fiz. 21 (1951) 588-597; L. D. Landau, E. M. Lifshitz, Mechanics, 3rd "
      "ed. "
      "(Butterworth-Heinemann, 1976), 30";
  static constexpr std::size_t size = 2;
  static constexpr std::array<Component, size> components{{{"phi", "rad"}, {"w", "rad/s"}}};
  static constexpr bool force_depends_on_velocity = false;

  Real L = 1, g = Real(157) / 16, a = Real(3) / 64, W = 128, phi0 = Real(1) / 4, t_end = 2;

  static constexpr auto parameters() {
    using P = Parameter<KapitzaPendulum, Real>;
    return std::array{P{"L", "m", "length", &KapitzaPendulum::L, positive},
                      P{"g", "m/s^2", "gravity", &KapitzaPendulum::g, not_negative},
                      P{"a", "m", "amplitude of the pivot", &KapitzaPendulum::a},
                      P{"W", "rad/s", "rate of the pivot", &KapitzaPendulum::W, positive},
                      P{"phi0", "rad", "initial angle from upright", &KapitzaPendulum::phi0},
                      P{"t_end", "s", "end of the interval", &KapitzaPendulum::t_end, positive}};
  }
  static constexpr std::array presets{
      Preset{"kapitza_pendulum", "", "a W = 6 m/s: stands, swinging slowly about upright"},
      Preset{"kapitza_pendulum_falling", "W=64", "a W = 3 m/s, less than 4.43: falls"}};

  std::array<double, size> scale() const { return {1, double(a) * double(W) / double(L) + 1}; }
  double suggested_dt() const { return 0.0625 / double(W); }

  template <class T>
  void initial(T* y) const {
    y[0] = T(phi0), y[1] = T(0);
  }
  template <class T>
  void acceleration(const T& t, const T* y, T* out) const {
    using std::cos, std::sin;
    out[0] = (T(g) - T(a) * T(W) * T(W) * cos(T(W) * t)) / T(L) * sin(y[0]);
  }
  template <class T>
  void rhs(const T& t, const T* y, T* dydt) const {
    dydt[0] = y[1];
    acceleration(t, y, &dydt[1]);
  }
  template <class T, class J>
  void jacobian(const T& t, const T* y, J&& j) const {
    using std::cos;
    j(0, 0) = T(0), j(0, 1) = T(1);
    j(1, 0) = (T(g) - T(a) * T(W) * T(W) * cos(T(W) * t)) / T(L) * cos(y[0]), j(1, 1) = T(0);
  }
};

}  // namespace odemark
