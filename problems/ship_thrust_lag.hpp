// A ship with quadratic drag whose propeller needs time to answer the telegraph.
#pragma once
#include <algorithm>

#include "problems/family.hpp"

namespace odemark {

/// State (s, v, F): the thrust follows what was ordered with a first-order lag.
template <class Real = double>
struct ShipThrustLag {
  static constexpr std::string_view id = "ship_thrust_lag";
  static constexpr std::string_view title = "Ship with quadratic drag and lagging thrust";
  static constexpr std::string_view equations = "s' = v;  v' = (F - c v |v|)/m;  F' = (order - F)/tau";
  static constexpr std::string_view source =
      "ours: E4 of DETEST, T. E. Hull et al., SIAM J. Numer. Anal. 9 (1972) 603-637, doi:10.1137/0709052, in "
      "SI "
      "units and behind a first-order lag";
  static constexpr std::size_t size = 3;
  static constexpr std::array<Component, size> components{{{"s", "m"}, {"v", "m/s"}, {"F", "N"}}};

  Real order = 1000000, tau = 8, c = 25000, m = 5000000, v0 = 0, F0 = 0, t_end = 120;

  static constexpr auto parameters() {
    using P = Parameter<ShipThrustLag, Real>;
    return std::array{P{"order", "N", "thrust that was ordered", &ShipThrustLag::order},
                      P{"tau", "s", "time constant of the thrust", &ShipThrustLag::tau, positive},
                      P{"c", "kg/m", "drag coefficient", &ShipThrustLag::c, positive},
                      P{"m", "kg", "mass", &ShipThrustLag::m, positive},
                      P{"v0", "m/s", "initial speed", &ShipThrustLag::v0},
                      P{"F0", "N", "initial thrust", &ShipThrustLag::F0},
                      P{"t_end", "s", "end of the interval", &ShipThrustLag::t_end, positive}};
  }
  static constexpr std::array presets{
      Preset{"ship_thrust_lag", "", "from rest with a propeller that takes 8 s"},
      Preset{"ship_thrust_lag_fast", "tau=1/64,t_end=60",
             "the lag is 2000 times faster than the ship: stiff, and of no interest after a moment"},
      Preset{"ship_thrust_lag_crash_stop", "order=-1000000,F0=1000000,v0=6.25",
             "full astern from full ahead: passes standstill, where the drag has its kink"}};

  std::array<double, size> scale() const {
    const double push = std::max({std::abs(double(order)), std::abs(double(F0)), 1.0}),
                 v = std::max(std::sqrt(push / double(c)), std::abs(double(v0)));
    return {v * double(t_end), v, push};
  }
  double suggested_dt() const { return std::min(0.5, 0.25 * double(tau)); }

  template <class T>
  void initial(T* y) const {
    y[0] = T(0), y[1] = T(v0), y[2] = T(F0);
  }
  template <class T>
  void rhs(const T&, const T* y, T* dydt) const {
    using std::abs;
    dydt[0] = y[1];
    dydt[1] = (y[2] - T(c) * (y[1] * abs(y[1]))) / T(m);
    dydt[2] = (T(order) - y[2]) / T(tau);
  }
  template <class T, class J>
  void jacobian(const T&, const T* y, J&& j) const {
    using std::abs;
    linear_part<T>(j);
    j(1, 1) = -2 * (T(c) / T(m)) * abs(y[1]);
  }
  template <class T, class L>
  void linear_part(L&& l) const {
    for (std::size_t row = 0; row < size; ++row)
      for (std::size_t column = 0; column < size; ++column) l(row, column) = T(0);
    l(0, 1) = T(1), l(1, 2) = 1 / T(m), l(2, 2) = -1 / T(tau);
  }
};

}  // namespace odemark
