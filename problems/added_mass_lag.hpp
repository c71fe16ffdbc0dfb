// A hull whose added mass acts through its acceleration of a moment ago: what a host does that feeds it back
// one step late.
#pragma once
#include <algorithm>

#include "problems/family.hpp"
#include "problems/plane_flow.hpp"

namespace odemark {

/// State (x, v, a): a follows v' with the lag tau. Explicit Euler with dt = tau is the late feedback itself
/// and diverges at once for added > m, whatever dt; the equation is stable for every ratio.
template <class Real = double>
struct AddedMassLag {
  static constexpr std::string_view id = "added_mass_lag";
  static constexpr std::string_view title = "Added mass fed back with a lag";
  static constexpr std::string_view equations = "x' = v;  m v' = F - c v - added a;  tau a' = v' - a";
  static constexpr std::string_view source =
      "ours; the late feedback of added mass and its limit added < m are described in issue 1923 of gz-sim "
      "(Open "
      "Robotics) and issue 1157 of WEC-Sim (NREL)";
  static constexpr std::size_t size = 3;
  static constexpr std::array<Component, size> components{{{"x", "m"}, {"v", "m/s"}, {"a", "m/s^2"}}};

  Real m = 1024, added = 2560, F = 1000, c = 100, tau = Real(1) / 64, v0 = 0, t_end = 60;

  static constexpr auto parameters() {
    using P = Parameter<AddedMassLag, Real>;
    return std::array{P{"m", "kg", "mass", &AddedMassLag::m, positive},
                      P{"added", "kg", "added mass", &AddedMassLag::added, not_negative},
                      P{"F", "N", "constant force", &AddedMassLag::F},
                      P{"c", "kg/s", "linear drag", &AddedMassLag::c, positive},
                      P{"tau", "s", "lag of the acceleration that is fed back", &AddedMassLag::tau, positive},
                      P{"v0", "m/s", "initial speed", &AddedMassLag::v0},
                      P{"t_end", "s", "end of the interval", &AddedMassLag::t_end, positive}};
  }
  static constexpr std::array presets{
      Preset{"added_mass_lag", "", "added mass of 2.5 masses: a root at -(1 + 2.5)/tau, 224 per second"},
      Preset{"added_mass_lag_light", "added=512,t_end=30", "half a mass: late feedback still settles"}};

  std::array<double, size> scale() const {
    const double v = std::max({std::abs(double(F)) / double(c), std::abs(double(v0)), 1e-6});
    return {v * double(t_end), v, v * double(c) / double(m)};
  }
  double suggested_dt() const { return 0.25 * double(tau); }

  template <class T>
  void initial(T* y) const {
    y[0] = T(0), y[1] = T(v0), y[2] = T(0);
  }
  template <class T>
  void rhs(const T&, const T* y, T* dydt) const {
    const T rate = (T(F) - T(c) * y[1] - T(added) * y[2]) / T(m);
    dydt[0] = y[1];
    dydt[1] = rate;
    dydt[2] = (rate - y[2]) / T(tau);
  }
  template <class T, class J>
  void jacobian(const T&, const T*, J&& j) const {
    linear_part<T>(j);
  }
  template <class T, class L>
  void linear_part(L&& l) const {
    for (std::size_t row = 0; row < size; ++row) l(row, 0) = T(0);
    l(0, 1) = T(1), l(0, 2) = T(0);
    l(1, 1) = -T(c) / T(m), l(1, 2) = -T(added) / T(m);
    l(2, 1) = -T(c) / T(m) / T(tau), l(2, 2) = -(T(added) / T(m) + T(1)) / T(tau);
  }
  /// The same system with every drive removed: 0 is its fixed point.
  AddedMassLag homogeneous() const {
    AddedMassLag unforced = *this;
    unforced.F = 0;
    return unforced;
  }

  /// The exact flow: y0 is the state at t = 0.
  template <class T>
  void exact(const T& t, const T* y0, T* y) const {
    const T drag = -T(c) / T(m), ratio = T(added) / T(m), steady = T(F) / T(c), x0 = y0[0];
    const PlaneFlow<T> flow{drag, T(-ratio), T(drag / T(tau)), T(-(ratio + 1) / T(tau))};
    const T start[2] = {y0[1] - steady, y0[2]};
    T now[2], way[2];
    flow(t, start, now);
    const T change[2] = {now[0] - start[0], now[1] - start[1]};
    flow.integral(change, way);
    y[0] = x0 + steady * t + way[0];
    y[1] = steady + now[0];
    y[2] = now[1];
  }
};

}  // namespace odemark
