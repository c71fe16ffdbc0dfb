// A ship in the plane: surge, sway and yaw, with added mass, a rudder and drag. The rigid body of two
// dimensions.
#pragma once
#include <algorithm>

#include "problems/family.hpp"

namespace odemark {

/// State (x, y, psi, u, v, r): position and heading in the plane, velocities along and across the hull, rate
/// of turn. Masses with the added ones differ along and across, so the water turns the hull broadside on.
template <class Real = double>
struct Ship3Dof {
  static constexpr std::string_view id = "ship_3dof";
  static constexpr std::string_view title = "Ship in surge, sway and yaw";
  static constexpr std::string_view equations =
      "x' = u cos psi - v sin psi;  y' = u sin psi + v cos psi;  psi' = r;  m1 u' = m2 v r + F - xuu u |u|;  "
      "m2 v' = -m1 u r + yd u^2 delta - (yv + yvv |v|) v;  "
      "m3 r' = (m1 - m2) u v - nd u^2 delta - (nr + nrr |r|) r";
  static constexpr std::string_view source =
      "T. I. Fossen, Handbook of Marine Craft Hydrodynamics and Motion Control (Wiley, 2011), ch. 6 and 7, "
      "with "
      "diagonal matrices; the numbers are those of a made-up ship of 5000 t";
  static constexpr std::size_t size = 6;
  static constexpr std::array<Component, size> components{
      {{"x", "m"}, {"y", "m"}, {"psi", "rad"}, {"u", "m/s"}, {"v", "m/s"}, {"r", "rad/s"}}};

  Real m1 = 5250000, m2 = 9000000, m3 = Real(2500000000.0), thrust = 1000000, delta = Real(1) / 4;
  Real xuu = 25000, yv = 250000, yvv = 200000, nr = 130000000, nrr = Real(3200000000.0), yd = 20000,
       nd = 720000;
  Real u0 = 6, v0 = 0, r0 = 0, t_end = 120;

  static constexpr auto parameters() {
    using P = Parameter<Ship3Dof, Real>;
    return std::array{P{"m1", "kg", "mass and added mass along the hull", &Ship3Dof::m1, positive},
                      P{"m2", "kg", "mass and added mass across the hull", &Ship3Dof::m2, positive},
                      P{"m3", "kg m^2", "moment of inertia with the added one", &Ship3Dof::m3, positive},
                      P{"thrust", "N", "propeller thrust", &Ship3Dof::thrust},
                      P{"delta", "rad", "angle of the rudder", &Ship3Dof::delta},
                      P{"xuu", "kg/m", "quadratic drag along the hull", &Ship3Dof::xuu, not_negative},
                      P{"yv", "kg/s", "linear drag across the hull", &Ship3Dof::yv, not_negative},
                      P{"yvv", "kg/m", "quadratic drag across the hull", &Ship3Dof::yvv, not_negative},
                      P{"nr", "N m s", "linear damping of the turn", &Ship3Dof::nr, not_negative},
                      P{"nrr", "N m s^2", "quadratic damping of the turn", &Ship3Dof::nrr, not_negative},
                      P{"yd", "kg/m", "side force of the rudder", &Ship3Dof::yd, not_negative},
                      P{"nd", "kg", "turning moment of the rudder", &Ship3Dof::nd, not_negative},
                      P{"u0", "m/s", "initial speed ahead", &Ship3Dof::u0},
                      P{"v0", "m/s", "initial speed to the side", &Ship3Dof::v0},
                      P{"r0", "rad/s", "initial rate of turn", &Ship3Dof::r0},
                      P{"t_end", "s", "end of the interval", &Ship3Dof::t_end, positive}};
  }
  static constexpr std::array presets{
      Preset{"ship_3dof", "", "a turning circle: position, heading and speeds come to depend on each other"},
      Preset{"ship_3dof_crash_stop", "thrust=-1000000",
             "full astern with the rudder laid: passes standstill"},
      Preset{"ship_3dof_drifting", "thrust=0,delta=0,u0=4,v0=1,r0=-1/64",
             "thrust gone: she turns broadside on and slows down, past kinks of the drag"}};

  std::array<double, size> scale() const {
    const double v = std::max({std::hypot(double(u0), double(v0)),
                               std::sqrt(std::abs(double(thrust)) / std::max(1.0, double(xuu))), 0.1});
    return {v * double(t_end), v * double(t_end), 1, v, v, v / 64};
  }
  double suggested_dt() const { return 0.5; }

  template <class T>
  void initial(T* y) const {
    y[0] = T(0), y[1] = T(0), y[2] = T(0);
    y[3] = T(u0), y[4] = T(v0), y[5] = T(r0);
  }
  template <class T>
  void rhs(const T&, const T* y, T* dydt) const {
    using std::abs, std::cos, std::sin;
    const T &u = y[3], &v = y[4], &r = y[5], c = cos(y[2]), s = sin(y[2]), rudder = u * u * T(delta);
    dydt[0] = u * c - v * s;
    dydt[1] = u * s + v * c;
    dydt[2] = r;
    dydt[3] = (T(m2) * (v * r) + T(thrust) - T(xuu) * (u * abs(u))) / T(m1);
    dydt[4] = (T(yd) * rudder - T(m1) * (u * r) - (T(yv) + T(yvv) * abs(v)) * v) / T(m2);
    dydt[5] = ((T(m1) - T(m2)) * (u * v) - T(nd) * rudder - (T(nr) + T(nrr) * abs(r)) * r) / T(m3);
  }
};

}  // namespace odemark
