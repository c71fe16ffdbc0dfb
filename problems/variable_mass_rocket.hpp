// A rocket that burns its fuel at a constant rate: Tsiolkovsky's equation, and the height that goes with it.
#pragma once
#include <algorithm>
#include <string>

#include "problems/family.hpp"

namespace odemark {

/// State (h, v, m). The acceleration grows without bound as the mass falls to nothing at m0/q.
template <class Real = double>
struct VariableMassRocket {
  static constexpr std::string_view id = "variable_mass_rocket";
  static constexpr std::string_view title = "Rocket of variable mass";
  static constexpr std::string_view equations = "h' = v;  v' = q ve/m - g;  m' = -q";
  static constexpr std::string_view source =
      "K. E. Tsiolkovsky, Nauchnoe Obozrenie 5 (1903); G. P. Sutton, O. Biblarz, Rocket Propulsion Elements, "
      "8th "
      "ed. (Wiley, 2010), ch. 4";
  static constexpr std::size_t size = 3;
  static constexpr std::array<Component, size> components{{{"h", "m"}, {"v", "m/s"}, {"m", "kg"}}};
  static constexpr std::array<std::string_view, 1> invariant_names{"tsiolkovsky"};

  Real ve = 2500, q = 5, m0 = 500, g = Real(157) / 16, v0 = 0, t_end = 60;

  static constexpr auto parameters() {
    using P = Parameter<VariableMassRocket, Real>;
    return std::array{P{"ve", "m/s", "exhaust speed", &VariableMassRocket::ve, not_negative},
                      P{"q", "kg/s", "mass burnt per second", &VariableMassRocket::q, positive},
                      P{"m0", "kg", "initial mass", &VariableMassRocket::m0, positive},
                      P{"g", "m/s^2", "gravity", &VariableMassRocket::g, not_negative},
                      P{"v0", "m/s", "initial speed upwards", &VariableMassRocket::v0},
                      P{"t_end", "s", "end of the interval", &VariableMassRocket::t_end, positive}};
  }
  static constexpr std::array presets{Preset{"variable_mass_rocket", "", "60 of 100 seconds of fuel"},
                                      Preset{"variable_mass_rocket_burnt_out", "t_end=99.5",
                                             "to a mass of half a per cent, where steps of one size fail"}};

  std::string validate() const { return q * t_end >= m0 ? "the rocket has burnt itself before t_end" : ""; }
  std::array<double, size> scale() const {
    const double v = double(ve) + std::abs(double(v0));
    return {v * double(t_end), v, double(m0)};
  }
  double suggested_dt() const { return 0.25 * (double(m0) / double(q) - double(t_end)) / 8; }

  template <class T>
  void initial(T* y) const {
    y[0] = T(0), y[1] = T(v0), y[2] = T(m0);
  }
  template <class T>
  void rhs(const T&, const T* y, T* dydt) const {
    dydt[0] = y[1];
    dydt[1] = T(q) * T(ve) / y[2] - T(g);
    dydt[2] = -T(q);
  }
  template <class T, class J>
  void jacobian(const T&, const T* y, J&& j) const {
    for (std::size_t row = 0; row < size; ++row)
      for (std::size_t column = 0; column < size; ++column) j(row, column) = T(0);
    j(0, 1) = T(1), j(1, 2) = -T(q) * T(ve) / (y[2] * y[2]);
  }

  /// The exact flow: y0 is the state at t = 0.
  template <class T>
  void exact(const T& t, const T* y0, T* y) const {
    using std::log;
    const T start = y0[2], left = start - T(q) * t, gained = T(ve) * log(start / left);
    y[0] = y0[0] + y0[1] * t + T(ve) * t - left / T(q) * gained - T(g) * t * t / 2;
    y[1] = y0[1] + gained - T(g) * t;
    y[2] = left;
  }
  /// In m/s: the speed less what the burnt mass has brought and gravity has taken.
  template <class T>
  void invariants(const T* y, T* out) const {
    using std::log;
    out[0] = y[1] + T(ve) * log(y[2] / T(m0)) - T(g) * (y[2] - T(m0)) / T(q);
  }
};

}  // namespace odemark
