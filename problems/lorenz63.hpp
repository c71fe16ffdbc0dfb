// Lorenz's three equations: how long can any method be right on a chaotic problem?
#pragma once
#include "problems/family.hpp"

namespace odemark {

/// State (x, y, z). Errors grow by e^0.9 per unit of time: at t = 10 double precision still has 10 digits, at
/// 50 none.
template <class Real = double>
struct Lorenz63 {
  static constexpr std::string_view id = "lorenz63";
  static constexpr std::string_view title = "Lorenz attractor";
  static constexpr std::string_view equations =
      "x' = sigma (y - x);  y' = x (rho - z) - y;  z' = x y - beta z";
  static constexpr std::string_view source =
      "E. N. Lorenz, J. Atmos. Sci. 20 (1963) 130-141, doi:10.1175/1520-0469(1963)020<0130:DNF>2.0.CO;2";
  static constexpr std::size_t size = 3;
  static constexpr std::array<Component, size> components{{{"x", ""}, {"y", ""}, {"z", ""}}};

  Real sigma = 10, rho = 28, beta = Real(8) / 3, x0 = 1, y0 = 1, z0 = 1, t_end = 10;

  static constexpr auto parameters() {
    using P = Parameter<Lorenz63, Real>;
    return std::array{P{"sigma", "", "Prandtl number", &Lorenz63::sigma, positive},
                      P{"rho", "", "Rayleigh number over its critical value", &Lorenz63::rho, positive},
                      P{"beta", "", "shape of the convection cell", &Lorenz63::beta, positive},
                      P{"x0", "", "initial convection", &Lorenz63::x0},
                      P{"y0", "", "initial temperature difference", &Lorenz63::y0},
                      P{"z0", "", "initial distortion of the temperature profile", &Lorenz63::z0},
                      P{"t_end", "", "end of the interval", &Lorenz63::t_end, positive}};
  }
  static constexpr std::array presets{
      Preset{"lorenz63", "", "from (1, 1, 1) for 10 units of time"},
      Preset{"lorenz63_t5", "t_end=5",
             "half of that: the end keeps 13 of 16 digits, for cost against error"}};

  std::array<double, size> scale() const { return {20, 25, 45}; }
  double suggested_dt() const { return 0.01; }

  template <class T>
  void initial(T* y) const {
    y[0] = T(x0), y[1] = T(y0), y[2] = T(z0);
  }
  template <class T>
  void rhs(const T&, const T* y, T* dydt) const {
    dydt[0] = T(sigma) * (y[1] - y[0]);
    dydt[1] = y[0] * (T(rho) - y[2]) - y[1];
    dydt[2] = y[0] * y[1] - T(beta) * y[2];
  }
  template <class T, class J>
  void jacobian(const T&, const T* y, J&& j) const {
    j(0, 0) = -T(sigma), j(0, 1) = T(sigma), j(0, 2) = T(0);
    j(1, 0) = T(rho) - y[2], j(1, 1) = T(-1), j(1, 2) = -y[0];
    j(2, 0) = y[1], j(2, 1) = y[0], j(2, 2) = -T(beta);
  }
};

}  // namespace odemark
