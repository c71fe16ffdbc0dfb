// Rossler's band: chaos with a single nonlinear term, in spikes that fixed steps must resolve.
#pragma once
#include "problems/family.hpp"

namespace odemark {

/// State (x, y, z). Errors grow by e^0.07 per unit of time.
template <class Real = double>
struct Rossler {
  static constexpr std::string_view id = "rossler";
  static constexpr std::string_view title = "Rossler attractor";
  static constexpr std::string_view equations = "x' = -y - z;  y' = x + a y;  z' = b + z (x - c)";
  static constexpr std::string_view source =
      "O. E. Rossler, Phys. Lett. A 57 (1976) 397-398, doi:10.1016/0375-9601(76)90101-8";
  static constexpr std::size_t size = 3;
  static constexpr std::array<Component, size> components{{{"x", ""}, {"y", ""}, {"z", ""}}};

  Real a = Real(1) / 5, b = Real(1) / 5, c = Real(57) / 10, x0 = 1, y0 = 1, z0 = 0, t_end = 50;

  static constexpr auto parameters() {
    using P = Parameter<Rossler, Real>;
    return std::array{P{"a", "", "growth rate of the spiral", &Rossler::a},
                      P{"b", "", "feed of z", &Rossler::b},
                      P{"c", "", "where z begins to grow", &Rossler::c},
                      P{"x0", "", "initial x", &Rossler::x0},
                      P{"y0", "", "initial y", &Rossler::y0},
                      P{"z0", "", "initial z", &Rossler::z0},
                      P{"t_end", "", "end of the interval", &Rossler::t_end, positive}};
  }
  static constexpr std::array presets{
      Preset{"rossler", "a=0.2,b=0.2,c=5.7", "eight turns of the usual attractor"},
      Preset{"rossler_period_one", "a=0.25,b=0.25,c=2.5,t_end=30", "drawn to a limit cycle: errors fade"}};

  std::array<double, size> scale() const { return {10, 10, 20}; }
  double suggested_dt() const { return 0.015625; }

  template <class T>
  void initial(T* y) const {
    y[0] = T(x0), y[1] = T(y0), y[2] = T(z0);
  }
  template <class T>
  void rhs(const T&, const T* y, T* dydt) const {
    dydt[0] = -y[1] - y[2];
    dydt[1] = y[0] + T(a) * y[1];
    dydt[2] = T(b) + y[2] * (y[0] - T(c));
  }
  template <class T, class J>
  void jacobian(const T&, const T* y, J&& j) const {
    j(0, 0) = T(0), j(0, 1) = T(-1), j(0, 2) = T(-1);
    j(1, 0) = T(1), j(1, 1) = T(a), j(1, 2) = T(0);
    j(2, 0) = y[2], j(2, 1) = T(0), j(2, 2) = y[0] - T(c);
  }
};

}  // namespace odemark
