// A ship answers its rudder: Nomoto's first-order model, with and without a helmsman.
#pragma once
#include <algorithm>
#include <string>

#include "problems/family.hpp"
#include "problems/plane_flow.hpp"

namespace odemark {

/// State (psi, r): heading and rate of turn. T and K are both negative for a ship that does not keep her
/// course by herself; kp and kd are those of an autopilot that steers to heading 0.
template <class Real = double>
struct NomotoYaw {
  static constexpr std::string_view id = "nomoto_yaw";
  static constexpr std::string_view title = "Ship's yaw after Nomoto";
  static constexpr std::string_view equations = "psi' = r;  r' = (K (delta - kp psi - kd r) - r)/T";
  static constexpr std::string_view source =
      "K. Nomoto, K. Taguchi, K. Honda, S. Hirano, Int. Shipbuilding Progress 4 (1957) 354-370; "
      "T. I. Fossen, Handbook of Marine Craft Hydrodynamics and Motion Control (Wiley, 2011), ch. 7";
  static constexpr std::size_t size = 2;
  static constexpr std::array<Component, size> components{{{"psi", "rad"}, {"r", "rad/s"}}};
  static constexpr bool force_depends_on_velocity = true;

  Real K = Real(1) / 16, T_ = 32, delta = Real(1) / 4, kp = 0, kd = 0, psi0 = 0, r0 = 0, t_end = 240;

  static constexpr auto parameters() {
    using P = Parameter<NomotoYaw, Real>;
    return std::array{P{"K", "1/s", "rate of turn per angle of rudder", &NomotoYaw::K},
                      P{"T", "s", "time constant; negative: unstable on course", &NomotoYaw::T_},
                      P{"delta", "rad", "constant angle of the rudder", &NomotoYaw::delta},
                      P{"kp", "", "rudder per angle off heading 0", &NomotoYaw::kp, not_negative},
                      P{"kd", "s", "rudder per rate of turn", &NomotoYaw::kd, not_negative},
                      P{"psi0", "rad", "initial heading", &NomotoYaw::psi0},
                      P{"r0", "rad/s", "initial rate of turn", &NomotoYaw::r0},
                      P{"t_end", "s", "end of the interval", &NomotoYaw::t_end, positive}};
  }
  static constexpr std::array presets{
      Preset{"nomoto_yaw", "", "rudder laid from rest: she comes to a steady turn in half a minute"},
      Preset{"nomoto_yaw_autopilot", "delta=0,kp=1,kd=24,psi0=0.5,t_end=120", "steered back to her course"},
      Preset{"nomoto_yaw_unstable", "K=-0.0625,T=-64,kp=2,kd=64,psi0=0.5,delta=0,t_end=120",
             "a tanker that only her autopilot keeps on course"}};

  std::string validate() const { return T_ == 0 ? "T=0 leaves no equation of motion" : ""; }
  std::array<double, size> scale() const {
    const double turn = std::abs(double(K) * double(delta)), start = std::abs(double(psi0)),
                 r = std::max({turn, start * std::sqrt(std::abs(double(kp) * double(K) / double(T_))),
                               std::abs(double(r0)), 1e-6});
    return {std::max(start, kp == 0 ? r * double(t_end) : r * std::abs(double(T_))), r};
  }
  double suggested_dt() const { return 0.5; }

  template <class T>
  void initial(T* y) const {
    y[0] = T(psi0), y[1] = T(r0);
  }
  template <class T>
  void acceleration(const T&, const T* y, T* a) const {
    a[0] = (T(K) * (T(delta) - T(kp) * y[0] - T(kd) * y[1]) - y[1]) / T(T_);
  }
  template <class T>
  void rhs(const T& t, const T* y, T* dydt) const {
    dydt[0] = y[1];
    acceleration(t, y, &dydt[1]);
  }
  template <class T, class J>
  void jacobian(const T&, const T*, J&& j) const {
    linear_part<T>(j);
  }
  template <class T, class L>
  void linear_part(L&& l) const {
    l(0, 0) = T(0), l(0, 1) = T(1);
    l(1, 0) = -(T(K) * T(kp)) / T(T_), l(1, 1) = -(T(K) * T(kd) + T(1)) / T(T_);
  }
  /// The same system with every drive removed: 0 is its fixed point.
  NomotoYaw homogeneous() const {
    NomotoYaw straight = *this;
    straight.delta = 0;
    return straight;
  }

  /// The exact flow: y0 is the state at t = 0.
  template <class T>
  void exact(const T& t, const T* y0, T* y) const {
    using std::expm1;
    const T pull = -T(K) * T(kp) / T(T_), damping = -(T(K) * T(kd) + 1) / T(T_),
            push = T(K) * T(delta) / T(T_);
    if (pull == 0) {  // no heading is preferred
      const T steady = damping == 0 ? T(0) : T(-push / damping);
      const T grown = damping == 0 ? t : T(expm1(damping * t) / damping);
      const T drift = damping == 0 ? T(push * t * t / 2) : T(steady * t);
      const T excess = y0[1] - steady;
      y[0] = y0[0] + drift + excess * grown;
      y[1] = y0[1] + (damping == 0 ? T(push * t) : T(excess * expm1(damping * t)));
      return;
    }
    const T rest = -push / pull, off[2] = {y0[0] - rest, y0[1]};
    PlaneFlow<T>{T(0), T(1), pull, damping}(t, off, y);
    y[0] += rest;
  }
};

}  // namespace odemark
