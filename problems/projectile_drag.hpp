// A shell with quadratic drag in the plane.
#pragma once
#include <algorithm>

#include "problems/family.hpp"

namespace odemark {

/// State (x, z, vx, vz). The hodograph is known: it gives an invariant, although no closed form in time.
template <class Real = double>
struct ProjectileDrag {
  static constexpr std::string_view id = "projectile_drag";
  static constexpr std::string_view title = "Projectile with quadratic drag";
  static constexpr std::string_view equations =
      "x' = vx;  z' = vz;  vx' = -k V vx;  vz' = -g - k V vz,  V = sqrt(vx^2 + vz^2)";
  static constexpr std::string_view source =
      "P. S. Chudinov, Eur. J. Phys. 25 (2004) 73-81, doi:10.1088/0143-0807/25/1/010; the hodograph is J. "
      "Bernoulli's of 1719";
  static constexpr std::size_t size = 4;
  static constexpr std::array<Component, size> components{
      {{"x", "m"}, {"z", "m"}, {"vx", "m/s"}, {"vz", "m/s"}}};
  static constexpr std::array<std::string_view, 1> invariant_names{"hodograph"};
  static constexpr bool force_depends_on_velocity = true;

  Real k = Real(1) / 128, g = Real(157) / 16, vx0 = 40, vz0 = 40, t_end = 5;

  static constexpr auto parameters() {
    using P = Parameter<ProjectileDrag, Real>;
    return std::array{P{"k", "1/m", "drag per mass and speed squared", &ProjectileDrag::k, positive},
                      P{"g", "m/s^2", "gravity", &ProjectileDrag::g, not_negative},
                      P{"vx0", "m/s", "initial speed ahead", &ProjectileDrag::vx0, positive},
                      P{"vz0", "m/s", "initial speed upwards", &ProjectileDrag::vz0},
                      P{"t_end", "s", "end of the interval", &ProjectileDrag::t_end, positive}};
  }
  static constexpr std::array presets{
      Preset{"projectile_drag", "", "thrown at 45 degrees with 57 m/s; falls steeply at the end"},
      Preset{"projectile_drag_fast", "k=1/16,vx0=600,vz0=300,t_end=4",
             "k V is 42 per second at first: over-large steps turn the flight around"},
      Preset{"projectile_drag_terminal", "vx0=4,vz0=0,k=1/4,t_end=2", "soon at its speed limit of 6.3 m/s"}};

  std::array<double, size> scale() const {
    const double v = std::hypot(double(vx0), double(vz0)),
                 range = std::min(v * double(t_end), 10 / double(k));
    return {range, range, v, v};
  }
  double suggested_dt() const {
    return std::min(0.05, 0.0625 / (double(k) * std::hypot(double(vx0), double(vz0))));
  }

  template <class T>
  void initial(T* y) const {
    y[0] = T(0), y[1] = T(0), y[2] = T(vx0), y[3] = T(vz0);
  }
  template <class T>
  void acceleration(const T&, const T* y, T* a) const {
    using std::sqrt;
    const T drag = -T(k) * sqrt(y[2] * y[2] + y[3] * y[3]);
    a[0] = drag * y[2];
    a[1] = drag * y[3] - T(g);
  }
  template <class T>
  void rhs(const T& t, const T* y, T* dydt) const {
    dydt[0] = y[2], dydt[1] = y[3];
    acceleration(t, y, &dydt[2]);
  }
  template <class T, class J>
  void jacobian(const T&, const T* y, J&& j) const {
    using std::sqrt;
    const T v = sqrt(y[2] * y[2] + y[3] * y[3]);
    for (std::size_t row = 0; row < 2; ++row)
      for (std::size_t column = 0; column < 2; ++column) {
        const T unit = row == column ? T(1) : T(0);
        j(row, column) = T(0), j(row, column + 2) = unit;
        j(row + 2, column) = T(0);
        j(row + 2, column + 2) = -T(k) * (v * unit + y[row + 2] * y[column + 2] / v);
      }
  }
  /// g/(k vx^2) + s sqrt(1 + s^2) + asinh s with the slope s = vz/vx.
  template <class T>
  void invariants(const T* y, T* out) const {
    using std::abs, std::log, std::sqrt;
    const T s = y[3] / y[2], root = sqrt(1 + s * s), area = log(abs(s) + root);
    out[0] = T(g) / (T(k) * y[2] * y[2]) + s * root + (s < 0 ? -area : area);
  }
};

}  // namespace odemark
