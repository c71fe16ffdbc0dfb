// A symmetric top on a table: fast spin, slow precession, nutation in between.
#pragma once
#include <algorithm>
#include <string>

#include "problems/family.hpp"

namespace odemark {

/// State (w, q): angular velocity along the axes of the body and the quaternion, scalar first, that turns
/// them into space. The weight pulls at a point of axis 3.
template <class Real = double>
struct LagrangeHeavyTop {
  static constexpr std::string_view id = "lagrange_heavy_top";
  static constexpr std::string_view title = "Heavy symmetric top";
  static constexpr std::string_view equations =
      "I w' = I w x w + mgl (e3 x -d),  d the vertical in the body;  q' = q (0, w)/2;  I = (I1, I1, I3)";
  static constexpr std::string_view source =
      "J.-L. Lagrange, Mecanique analytique (1788); H. Goldstein, Classical Mechanics, 2nd ed. "
      "(Addison-Wesley, "
      "1980), 5-7";
  static constexpr std::size_t size = 7;
  static constexpr std::array<Component, size> components{
      {{"w1", "rad/s"}, {"w2", "rad/s"}, {"w3", "rad/s"}, {"q0", ""}, {"q1", ""}, {"q2", ""}, {"q3", ""}}};
  static constexpr std::array<std::string_view, 4> invariant_names{"energy", "vertical_momentum", "spin",
                                                                   "norm_squared"};

  Real I1 = 1, I3 = Real(1) / 2, mgl = 1, spin = 20, h = Real(5) / 64, swing = 0, t_end = 20;

  static constexpr auto parameters() {
    using P = Parameter<LagrangeHeavyTop, Real>;
    return std::array{
        P{"I1", "kg m^2", "moment of inertia across, about the tip", &LagrangeHeavyTop::I1, positive},
        P{"I3", "kg m^2", "moment of inertia about the axis", &LagrangeHeavyTop::I3, positive},
        P{"mgl", "N m", "weight times distance from the tip", &LagrangeHeavyTop::mgl},
        P{"spin", "rad/s", "initial spin about the axis", &LagrangeHeavyTop::spin},
        P{"h", "", "tangent of a quarter of the initial angle from the vertical", &LagrangeHeavyTop::h},
        P{"swing", "rad/s", "initial rate about axis 2", &LagrangeHeavyTop::swing},
        P{"t_end", "s", "end of the interval", &LagrangeHeavyTop::t_end, positive}};
  }
  static constexpr std::array presets{
      Preset{"lagrange_heavy_top", "", "a fast top let go: cusps of 0.006 rad on a precession of 0.1 rad/s"},
      Preset{"lagrange_heavy_top_slow", "spin=4,h=1/4,swing=0.25", "deep nutation: loops instead of cusps"},
      Preset{"lagrange_heavy_top_rising", "spin=3.5,h=1/256,t_end=30",
             "too slow to sleep upright, 2 sqrt(mgl I1)/I3 = 4 rad/s: it falls and rises again"}};

  std::string validate() const {
    return I3 > 2 * I1 ? "no body has a principal moment of inertia greater than the sum of the other two"
                       : "";
  }
  std::array<double, size> scale() const {
    const double rate = std::max({std::abs(double(spin)), std::abs(double(swing)), 1.0});
    return {rate, rate, rate, 1, 1, 1, 1};
  }
  double suggested_dt() const { return 0.0625 / scale()[0]; }

  template <class T>
  void initial(T* y) const {
    const T below = 1 + T(h) * T(h);
    y[0] = T(0), y[1] = T(swing), y[2] = T(spin);
    y[3] = (1 - T(h) * T(h)) / below, y[4] = 2 * T(h) / below, y[5] = T(0), y[6] = T(0);
  }
  static constexpr std::size_t rate_at = 0, attitude_at = 3;  // of w and q in the state
  template <class T>
  void inertia(T* out) const {
    out[0] = T(I1), out[1] = T(I1), out[2] = T(I3);
  }
  /// mgl e3 x -(vertical in the body).
  template <class T>
  void torque(const T&, const T* y, T* out) const {
    const T* q = y + 3;
    out[0] = 2 * T(mgl) * (q[2] * q[3] + q[0] * q[1]);
    out[1] = -2 * T(mgl) * (q[1] * q[3] - q[0] * q[2]);
    out[2] = T(0);
  }
  template <class T>
  void rhs(const T& t, const T* y, T* dydt) const {
    const T &a = y[0], &b = y[1], &c = y[2];
    const T lead = T(1) - T(I3) / T(I1);
    T turn[3];
    torque(t, y, turn);
    dydt[0] = lead * b * c + turn[0] / T(I1);
    dydt[1] = -lead * c * a + turn[1] / T(I1);
    dydt[2] = T(0);
    dydt[3] = -(a * y[4] + b * y[5] + c * y[6]) / 2;
    dydt[4] = (a * y[3] + c * y[5] - b * y[6]) / 2;
    dydt[5] = (b * y[3] + a * y[6] - c * y[4]) / 2;
    dydt[6] = (c * y[3] + b * y[4] - a * y[5]) / 2;
  }
  /// All of them hold for a quaternion of any norm.
  template <class T>
  void invariants(const T* y, T* out) const {
    const T* q = y + 3;
    const T up1 = 2 * (q[1] * q[3] - q[0] * q[2]), up2 = 2 * (q[2] * q[3] + q[0] * q[1]);
    const T up3 = q[0] * q[0] - q[1] * q[1] - q[2] * q[2] + q[3] * q[3];
    out[0] = (T(I1) * (y[0] * y[0] + y[1] * y[1]) + T(I3) * y[2] * y[2]) / 2 + T(mgl) * up3;
    out[1] = T(I1) * (y[0] * up1 + y[1] * up2) + T(I3) * y[2] * up3;
    out[2] = y[2];
    out[3] = q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3];
  }
};

}  // namespace odemark
