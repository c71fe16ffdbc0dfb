// A star in the field of a galaxy: order and chaos at the same energy.
#pragma once
#include "problems/family.hpp"

namespace odemark {

/// State (x, y, vx, vy).
template <class Real = double>
struct HenonHeiles {
  static constexpr std::string_view id = "henon_heiles";
  static constexpr std::string_view title = "Henon-Heiles system";
  static constexpr std::string_view equations = "x'' = -x - 2 lambda x y;  y'' = -y - lambda (x^2 - y^2)";
  static constexpr std::string_view source =
      "M. Henon, C. Heiles, Astron. J. 69 (1964) 73-79, doi:10.1086/109234";
  static constexpr std::size_t size = 4;
  static constexpr std::array<Component, size> components{{{"x", ""}, {"y", ""}, {"vx", ""}, {"vy", ""}}};
  static constexpr std::array<std::string_view, 1> invariant_names{"energy"};
  static constexpr bool force_depends_on_velocity = false;

  Real lambda = 1, x0 = Real(1) / 8, y0 = 0, vx0 = 0, vy0 = Real(3) / 8, t_end = 50;

  static constexpr auto parameters() {
    using P = Parameter<HenonHeiles, Real>;
    return std::array{P{"lambda", "", "strength of the cubic terms", &HenonHeiles::lambda},
                      P{"x0", "", "initial x", &HenonHeiles::x0},
                      P{"y0", "", "initial y", &HenonHeiles::y0},
                      P{"vx0", "", "initial vx", &HenonHeiles::vx0},
                      P{"vy0", "", "initial vy", &HenonHeiles::vy0},
                      P{"t_end", "", "end of the interval", &HenonHeiles::t_end, positive}};
  }
  static constexpr std::array presets{
      Preset{"henon_heiles", "", "energy 0.078, below 1/12: regular motion on tori"},
      Preset{"henon_heiles_chaotic", "x0=0,y0=-0.125,vx0=0.46875,vy0=0.1875,t_end=100",
             "energy 0.136, nearly 1/6: most orbits are chaotic"}};

  std::array<double, size> scale() const { return {0.5, 0.5, 0.5, 0.5}; }
  double suggested_dt() const { return 0.0625; }

  template <class T>
  void initial(T* y) const {
    y[0] = T(x0), y[1] = T(y0), y[2] = T(vx0), y[3] = T(vy0);
  }
  template <class T>
  void acceleration(const T&, const T* y, T* a) const {
    a[0] = -y[0] - 2 * T(lambda) * (y[0] * y[1]);
    a[1] = -y[1] - T(lambda) * (y[0] * y[0] - y[1] * y[1]);
  }
  template <class T>
  void rhs(const T& t, const T* y, T* dydt) const {
    dydt[0] = y[2], dydt[1] = y[3];
    acceleration(t, y, &dydt[2]);
  }
  template <class T, class J>
  void jacobian(const T&, const T* y, J&& j) const {
    linear_part<T>(j);
    const T x = 2 * T(lambda) * y[0], z = 2 * T(lambda) * y[1];
    j(2, 0) = -1 - z, j(2, 1) = -x;
    j(3, 0) = -x, j(3, 1) = z - 1;
  }
  template <class T, class L>
  void linear_part(L&& l) const {
    for (std::size_t row = 0; row < size; ++row)
      for (std::size_t column = 0; column < size; ++column)
        l(row, column) = T(row + 2 == column ? 1 : column + 2 == row ? -1 : 0);
  }
  template <class T>
  void invariants(const T* y, T* out) const {
    out[0] = (y[0] * y[0] + y[1] * y[1] + y[2] * y[2] + y[3] * y[3]) / 2 +
             T(lambda) * (y[0] * y[0] * y[1] - y[1] * y[1] * y[1] / 3);
  }
};

}  // namespace odemark
