// A rate that is commanded through an actuator with a time constant, as in every flight simulator.
#pragma once
#include <algorithm>
#include <string>

#include "problems/family.hpp"

namespace odemark {

/// State (p, u): rate of roll and deflection. Explicit Euler needs dt < 2 tau, whatever the aeroplane does.
template <class Real = double>
struct ActuatorLag {
  static constexpr std::string_view id = "actuator_lag";
  static constexpr std::string_view title = "Roll behind an actuator lag";
  static constexpr std::string_view equations = "p' = -Lp p + Ld u;  tau u' = A sin W t - u";
  static constexpr std::string_view source =
      "B. L. Stevens, F. L. Lewis, Aircraft Control and Simulation, 2nd ed. (Wiley, 2003), ch. 4; time "
      "constants of 5 "
      "and 50 ms as in issue 17032 of PX4-Autopilot";
  static constexpr std::size_t size = 2;
  static constexpr std::array<Component, size> components{{{"p", "rad/s"}, {"u", "rad"}}};

  Real Lp = 2, Ld = 8, tau = Real(3) / 64, A = Real(1) / 4, W = 5, t_end = 5;

  static constexpr auto parameters() {
    using P = Parameter<ActuatorLag, Real>;
    return std::array{P{"Lp", "1/s", "damping in roll", &ActuatorLag::Lp, positive},
                      P{"Ld", "1/s^2", "acceleration per deflection", &ActuatorLag::Ld},
                      P{"tau", "s", "time constant of the actuator", &ActuatorLag::tau, positive},
                      P{"A", "rad", "amplitude of the command", &ActuatorLag::A},
                      P{"W", "rad/s", "rate of the command", &ActuatorLag::W, positive},
                      P{"t_end", "s", "end of the interval", &ActuatorLag::t_end, positive}};
  }
  static constexpr std::array presets{
      Preset{"actuator_lag", "", "47 ms: three steps of 60 Hz"},
      Preset{"actuator_lag_fast", "tau=1/256", "4 ms: explicit Euler at 60 Hz blows up, at 250 Hz it rings"}};

  std::string validate() const {
    return Lp * tau == 1 ? "Lp tau = 1: two equal rates have no closed form here; change one a little" : "";
  }
  std::array<double, size> scale() const {
    const double u = std::max(std::abs(double(A)), 1e-6);
    return {u * std::max(1.0, std::abs(double(Ld)) / double(Lp)), u};
  }
  double suggested_dt() const { return 0.0625 / std::max({double(W), double(Lp), 0.5 / double(tau)}); }

  template <class T>
  void initial(T* y) const {
    y[0] = T(0), y[1] = T(0);
  }
  template <class T>
  void rhs(const T& t, const T* y, T* dydt) const {
    using std::sin;
    dydt[0] = T(Ld) * y[1] - T(Lp) * y[0];
    dydt[1] = (T(A) * sin(T(W) * t) - y[1]) / T(tau);
  }
  template <class T, class J>
  void jacobian(const T&, const T*, J&& j) const {
    linear_part<T>(j);
  }
  template <class T, class L>
  void linear_part(L&& l) const {
    l(0, 0) = -T(Lp), l(0, 1) = T(Ld), l(1, 0) = T(0), l(1, 1) = -1 / T(tau);
  }
  /// The same system with every drive removed: 0 is its fixed point.
  ActuatorLag homogeneous() const {
    ActuatorLag hands_off = *this;
    hands_off.A = 0;
    return hands_off;
  }

  /// The exact flow: y0 is the state at t = 0. Sine and cosine are the steady answer, the rest decays.
  template <class T>
  void exact(const T& t, const T* y0, T* y) const {
    using std::cos, std::exp, std::sin;
    const T w = T(W), slow = T(Lp), fast = 1 / T(tau), s = sin(w * t), c = cos(w * t);
    const T us = T(A) * fast * fast / (fast * fast + w * w), uc = -us * w / fast;  // u = us sin + uc cos
    const T below = slow * slow + w * w;
    const T ps = T(Ld) * (us * slow + uc * w) / below, pc = T(Ld) * (uc * slow - us * w) / below;
    const T off = y0[1] - uc, through = T(Ld) * off / (slow - fast), rest = y0[0] - pc - through;
    const T ef = exp(-fast * t), es = exp(-slow * t);
    y[0] = ps * s + pc * c + through * ef + rest * es;
    y[1] = us * s + uc * c + off * ef;
  }
};

}  // namespace odemark
