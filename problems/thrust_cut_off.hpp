// A body that is pushed until the engine is cut off between two steps: every method is of first order here,
// but one that stops at the instant.
#pragma once
#include <algorithm>

#include "problems/family.hpp"

namespace odemark {

/// State (x, v). Without the switch every method of second order would be exact.
template <class Real = double>
struct ThrustCutOff {
  static constexpr std::string_view id = "thrust_cut_off";
  static constexpr std::string_view title = "Thrust that is cut off";
  static constexpr std::string_view equations = "x' = v;  v' = a for t < t_off, 0 after";
  static constexpr std::string_view source =
      "ours: uniformly accelerated motion up to an instant that no step meets";
  static constexpr std::size_t size = 2;
  static constexpr std::array<Component, size> components{{{"x", "m"}, {"v", "m/s"}}};
  static constexpr bool force_depends_on_velocity = false;

  Real a = 10, t_off = Real(4289) / 4096, x0 = 0, v0 = 0, t_end = 2;

  static constexpr auto parameters() {
    using P = Parameter<ThrustCutOff, Real>;
    return std::array{P{"a", "m/s^2", "acceleration before the cut-off", &ThrustCutOff::a},
                      P{"t_off", "s", "the instant of the cut-off", &ThrustCutOff::t_off, not_negative},
                      P{"x0", "m", "initial position", &ThrustCutOff::x0},
                      P{"v0", "m/s", "initial speed", &ThrustCutOff::v0},
                      P{"t_end", "s", "end of the interval", &ThrustCutOff::t_end, positive}};
  }
  static constexpr std::array presets{
      Preset{"thrust_cut_off", "", "near pi/3 s, on no step of any frame rate"},
      Preset{"thrust_cut_off_on_step", "t_off=1",
             "on a step of every frame rate: what is lost at a switch that is met"}};

  std::array<double, size> scale() const {
    const double v = std::max({std::abs(double(a)) * double(t_end) / 2, std::abs(double(v0)), 1e-6});
    return {v * double(t_end), v};
  }
  double suggested_dt() const { return 1.0 / 64; }
  /// The instants at which the right-hand side jumps.
  std::array<double, 1> switch_times() const { return {double(t_off)}; }
  /// The smooth problem of phase n: before the cut-off (0), after it (1).
  ThrustCutOff during(std::size_t phase) const {
    ThrustCutOff held = *this;
    held.t_off =
        phase == 0 ? std::numeric_limits<Real>::infinity() : Real(-std::numeric_limits<Real>::infinity());
    return held;
  }

  template <class T>
  void initial(T* y) const {
    y[0] = T(x0), y[1] = T(v0);
  }
  template <class T>
  void acceleration(const T& t, const T*, T* out) const {
    out[0] = step_at(t, t_off, a, Real(0));
  }
  template <class T>
  void rhs(const T& t, const T* y, T* dydt) const {
    dydt[0] = y[1];
    acceleration(t, y, &dydt[1]);
  }
  template <class T, class J>
  void jacobian(const T&, const T*, J&& j) const {
    j(0, 0) = T(0), j(0, 1) = T(1), j(1, 0) = T(0), j(1, 1) = T(0);
  }
  /// The exact flow for t >= 0: y0 is the state at t = 0.
  template <class T>
  void exact(const T& t, const T* y0, T* y) const {
    const T burnt = std::clamp(T(t_off), T(0), t), gained = T(a) * burnt;
    y[0] = y0[0] + y0[1] * t + gained * burnt / 2 + gained * (t - burnt);
    y[1] = y0[1] + gained;
  }
};

}  // namespace odemark
