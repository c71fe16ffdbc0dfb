// The same car with tyres that need a length of road to build up their force: no longer stiff at rest, but
// hardly damped.
#pragma once
#include <algorithm>

#include "problems/family.hpp"
#include "problems/plane_flow.hpp"

namespace odemark {

/// State (y, v, a): displacement to the side, its rate, slip of the tyres. The damping ratio is
/// u sqrt(m/(4 C sigma)): none at rest, where explicit Euler then grows.
template <class Real = double>
struct TyreRelaxation {
  static constexpr std::string_view id = "tyre_relaxation";
  static constexpr std::string_view title = "Side force of a tyre with relaxation length";
  static constexpr std::string_view equations = "y' = v;  v' = -C a/m;  sigma a' = v - u a";
  static constexpr std::string_view source =
      "H. B. Pacejka, Tire and Vehicle Dynamics, 3rd ed. (Butterworth-Heinemann, 2012), ch. 7 and 8; B. von "
      "Schlippe, "
      "R. Dietrich, Lilienthal-Gesellschaft 140 (1941)";
  static constexpr std::size_t size = 3;
  static constexpr std::array<Component, size> components{{{"y", "m"}, {"v", "m/s"}, {"a", "rad"}}};

  Real C = 160000, m = 1500, sigma = Real(1) / 2, u = 16, v0 = 2, t_end = 2;

  static constexpr auto parameters() {
    using P = Parameter<TyreRelaxation, Real>;
    return std::array{P{"C", "N/rad", "cornering stiffness of all tyres", &TyreRelaxation::C, positive},
                      P{"m", "kg", "mass", &TyreRelaxation::m, positive},
                      P{"sigma", "m", "relaxation length", &TyreRelaxation::sigma, positive},
                      P{"u", "m/s", "rolling speed", &TyreRelaxation::u, not_negative},
                      P{"v0", "m/s", "initial speed to the side", &TyreRelaxation::v0},
                      P{"t_end", "s", "end of the interval", &TyreRelaxation::t_end, positive}};
  }
  static constexpr std::array presets{
      Preset{"tyre_relaxation", "", "at 58 km/h: 14.6 rad/s, well damped"},
      Preset{"tyre_relaxation_parking", "u=1/4,v0=0.25,t_end=10", "nearly at rest: swings on its tyres"}};

  std::array<double, size> scale() const {
    const double v = std::max(std::abs(double(v0)), 1e-3),
                 w = std::sqrt(double(C) / (double(m) * double(sigma)));
    return {v / w, v, v / (w * double(sigma))};
  }
  double suggested_dt() const {
    return 0.0625 / std::max(std::sqrt(double(C) / (double(m) * double(sigma))), double(u) / double(sigma));
  }

  template <class T>
  void initial(T* y) const {
    y[0] = T(0), y[1] = T(v0), y[2] = T(0);
  }
  template <class T>
  void rhs(const T&, const T* y, T* dydt) const {
    dydt[0] = y[1];
    dydt[1] = -T(C) / T(m) * y[2];
    dydt[2] = (y[1] - T(u) * y[2]) / T(sigma);
  }
  template <class T, class J>
  void jacobian(const T&, const T*, J&& j) const {
    linear_part<T>(j);
  }
  template <class T, class L>
  void linear_part(L&& l) const {
    for (std::size_t row = 0; row < size; ++row)
      for (std::size_t column = 0; column < size; ++column) l(row, column) = T(0);
    l(0, 1) = T(1), l(1, 2) = -T(C) / T(m);
    l(2, 1) = 1 / T(sigma), l(2, 2) = -T(u) / T(sigma);
  }
  /// The same system with every drive removed: 0 is its fixed point.
  TyreRelaxation homogeneous() const { return *this; }

  /// The exact flow: y0 is the state at t = 0.
  template <class T>
  void exact(const T& t, const T* y0, T* y) const {
    const PlaneFlow<T> flow{T(0), T(-T(C) / T(m)), T(1 / T(sigma)), T(-T(u) / T(sigma))};
    const T start[2] = {y0[1], y0[2]}, from = y0[0];
    T now[2], way[2];
    flow(t, start, now);
    const T change[2] = {now[0] - start[0], now[1] - start[1]};
    flow.integral(change, way);
    y[0] = from + way[0], y[1] = now[0], y[2] = now[1];
  }
};

}  // namespace odemark
