// A flat body that moves through a fluid without friction: what added mass alone does.
#pragma once
#include <algorithm>

#include "problems/family.hpp"

namespace odemark {

/// State (x, y, psi, u, v, r) as of a ship. Twice the heading against the momentum is a pendulum: the body
/// swings about the position broadside on, or turns over.
template <class Real = double>
struct KirchhoffBody {
  static constexpr std::string_view id = "kirchhoff_body";
  static constexpr std::string_view title = "Body in an ideal fluid, in the plane";
  static constexpr std::string_view equations =
      "x' = u cos psi - v sin psi;  y' = u sin psi + v cos psi;  psi' = r;  m1 u' = m2 v r;  m2 v' = -m1 u "
      "r;  "
      "m3 r' = (m1 - m2) u v";
  static constexpr std::string_view source =
      "G. Kirchhoff, J. reine angew. Math. 71 (1870) 237-262; H. Lamb, Hydrodynamics, 6th ed. (Cambridge, "
      "1932), "
      "124-127";
  static constexpr std::size_t size = 6;
  static constexpr std::array<Component, size> components{
      {{"x", "m"}, {"y", "m"}, {"psi", "rad"}, {"u", "m/s"}, {"v", "m/s"}, {"r", "rad/s"}}};
  static constexpr std::array<std::string_view, 4> invariant_names{"energy", "momentum_x", "momentum_y",
                                                                   "angular_momentum"};

  Real m1 = 1, m2 = 2, m3 = Real(1) / 2, u0 = 1, v0 = 0, r0 = Real(1) / 8, t_end = 20;

  static constexpr auto parameters() {
    using P = Parameter<KirchhoffBody, Real>;
    return std::array{P{"m1", "kg", "mass and added mass along axis 1", &KirchhoffBody::m1, positive},
                      P{"m2", "kg", "mass and added mass along axis 2", &KirchhoffBody::m2, positive},
                      P{"m3", "kg m^2", "moment of inertia with the added one", &KirchhoffBody::m3, positive},
                      P{"u0", "m/s", "initial speed along axis 1", &KirchhoffBody::u0},
                      P{"v0", "m/s", "initial speed along axis 2", &KirchhoffBody::v0},
                      P{"r0", "rad/s", "initial rate of turn", &KirchhoffBody::r0},
                      P{"t_end", "s", "end of the interval", &KirchhoffBody::t_end, positive}};
  }
  static constexpr std::array presets{
      Preset{"kirchhoff_body", "", "end on, the unstable way: it turns over and over and lingers in between"},
      Preset{"kirchhoff_body_swinging", "u0=0.25,v0=1,r0=0.5", "broadside on, the stable way"},
      Preset{"kirchhoff_body_turning", "r0=4,t_end=8", "fast enough to turn over for ever"}};

  std::array<double, size> scale() const {
    const double v = std::max(std::hypot(double(u0), double(v0)), 1e-3);
    return {v * double(t_end), v * double(t_end), 1, v, v, std::max(v, std::abs(double(r0)))};
  }
  double suggested_dt() const { return 0.05 / std::max(1.0, std::abs(double(r0)) / 2); }

  template <class T>
  void initial(T* y) const {
    y[0] = T(0), y[1] = T(0), y[2] = T(0);
    y[3] = T(u0), y[4] = T(v0), y[5] = T(r0);
  }
  template <class T>
  void rhs(const T&, const T* y, T* dydt) const {
    using std::cos, std::sin;
    const T &u = y[3], &v = y[4], &r = y[5], c = cos(y[2]), s = sin(y[2]);
    dydt[0] = u * c - v * s;
    dydt[1] = u * s + v * c;
    dydt[2] = r;
    dydt[3] = (T(m2) / T(m1)) * (v * r);
    dydt[4] = -(T(m1) / T(m2)) * (u * r);
    dydt[5] = ((T(m1) - T(m2)) / T(m3)) * (u * v);
  }
  template <class T>
  void invariants(const T* y, T* out) const {
    using std::cos, std::sin;
    const T along = T(m1) * y[3], across = T(m2) * y[4], c = cos(y[2]), s = sin(y[2]);
    out[0] = (along * y[3] + across * y[4] + T(m3) * y[5] * y[5]) / 2;
    out[1] = along * c - across * s;
    out[2] = along * s + across * c;
    out[3] = T(m3) * y[5] + y[0] * out[2] - y[1] * out[1];
  }
};

}  // namespace odemark
