// A car that slides sideways while it rolls: the side force of a tyre, stiffer the slower it rolls.
#pragma once
#include <algorithm>

#include "problems/family.hpp"

namespace odemark {

/// State (y, v): displacement to the side and its rate. Near v = 0 the rate is C/(m u): without bound as the
/// car comes to a halt.
template <class Real = double>
struct TyreSideForce {
  static constexpr std::string_view id = "tyre_side_force";
  static constexpr std::string_view title = "Side force of a tyre";
  static constexpr std::string_view equations = "y' = v;  v' = -C/m atan(v/u)";
  static constexpr std::string_view source =
      "H. B. Pacejka, Tire and Vehicle Dynamics, 3rd ed. (Butterworth-Heinemann, 2012), ch. 1 and 8; J. E. "
      "Bernard, "
      "C. L. Clover, SAE Technical Paper 950311 (1995), doi:10.4271/950311, on low speeds";
  static constexpr std::size_t size = 2;
  static constexpr std::array<Component, size> components{{{"y", "m"}, {"v", "m/s"}}};
  static constexpr bool force_depends_on_velocity = true;

  Real C = 160000, m = 1500, u = 16, v0 = 2, t_end = 1;

  static constexpr auto parameters() {
    using P = Parameter<TyreSideForce, Real>;
    return std::array{P{"C", "N/rad", "cornering stiffness of all tyres", &TyreSideForce::C, positive},
                      P{"m", "kg", "mass", &TyreSideForce::m, positive},
                      P{"u", "m/s", "rolling speed", &TyreSideForce::u, positive},
                      P{"v0", "m/s", "initial speed to the side", &TyreSideForce::v0},
                      P{"t_end", "s", "end of the interval", &TyreSideForce::t_end, positive}};
  }
  static constexpr std::array presets{
      Preset{"tyre_side_force", "", "at 58 km/h: gone in half a second"},
      Preset{"tyre_side_force_slow", "u=0.5,v0=0.5,t_end=0.25",
             "at walking pace: 213 per second, too fast for Euler at 60 Hz"},
      Preset{"tyre_side_force_parking", "u=1/64,v0=0.25,t_end=1/32", "nearly at rest: 6827 per second"}};

  std::array<double, size> scale() const {
    const double v = std::max(std::abs(double(v0)), 1e-3);
    return {v * double(t_end), v};
  }
  double suggested_dt() const { return std::min(0.03125, 0.25 * double(m) * double(u) / double(C)); }

  template <class T>
  void initial(T* y) const {
    y[0] = T(0), y[1] = T(v0);
  }
  template <class T>
  void acceleration(const T&, const T* y, T* a) const {
    using std::atan;
    a[0] = -T(C) / T(m) * atan(y[1] / T(u));
  }
  template <class T>
  void rhs(const T& t, const T* y, T* dydt) const {
    dydt[0] = y[1];
    acceleration(t, y, &dydt[1]);
  }
  template <class T, class J>
  void jacobian(const T&, const T* y, J&& j) const {
    const T slip = y[1] / T(u);
    j(0, 0) = T(0), j(0, 1) = T(1);
    j(1, 0) = T(0), j(1, 1) = -T(C) / T(m) / T(u) / (1 + slip * slip);
  }
};

}  // namespace odemark
