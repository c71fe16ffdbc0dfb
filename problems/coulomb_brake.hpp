// Dry friction brings a body to rest: the force jumps where the speed is 0, and then holds.
#pragma once
#include <algorithm>

#include "problems/family.hpp"

namespace odemark {

/// State (s, v), starting with v > 0. Friction opposes the motion with mu g. At standstill it holds against
/// any pull up to that; against more the body turns round.
template <class Real = double>
struct CoulombBrake {
  static constexpr std::string_view id = "coulomb_brake";
  static constexpr std::string_view title = "Braking by dry friction";
  static constexpr std::string_view equations =
      "s' = v;  v' = pull - mu g sign(v), at rest where |pull| <= mu g";
  static constexpr std::string_view source =
      "C. A. Coulomb, Theorie des machines simples (1785); J. J. Moreau, in Nonsmooth Mechanics and "
      "Applications, CISM "
      "302 (Springer, 1988) 1-82, doi:10.1007/978-3-7091-2624-0_1; parameters are ours";
  static constexpr std::size_t size = 2;
  static constexpr std::array<Component, size> components{{{"s", "m"}, {"v", "m/s"}}};
  static constexpr std::array<std::string_view, 1> events{"standstill"};
  static constexpr std::size_t phase_count = 3;  // forwards, at rest, backwards
  static constexpr bool force_depends_on_velocity = false;

  Real mu = Real(5) / 16, g = Real(628) / 64, pull = 0, v0 = 5, t_end = 3;
  int direction = 1;  // of the motion in this phase

  static constexpr auto parameters() {
    using P = Parameter<CoulombBrake, Real>;
    return std::array{P{"mu", "", "coefficient of friction", &CoulombBrake::mu, not_negative},
                      P{"g", "m/s^2", "gravity", &CoulombBrake::g, positive},
                      P{"pull", "m/s^2", "constant force per mass along the way", &CoulombBrake::pull},
                      P{"v0", "m/s", "initial speed", &CoulombBrake::v0, positive},
                      P{"t_end", "s", "end of the interval", &CoulombBrake::t_end, positive}};
  }
  static constexpr std::array presets{
      Preset{"coulomb_brake", "",
             "stops at 1.63 s and stays: without a rest state it would chatter for ever"},
      Preset{"coulomb_brake_pulled", "pull=2,t_end=8", "a gentle stop at 4.69 s, held against a pull"},
      Preset{"coulomb_brake_slope", "pull=-4", "the slope is too steep: it slides back from 0.71 s on"}};

  std::array<double, size> scale() const { return {double(v0) * double(t_end) / 2, double(v0)}; }
  double suggested_dt() const { return 1.0 / 64; }
  CoulombBrake during(std::size_t phase) const {
    CoulombBrake held = *this;
    held.direction = 1 - int(phase);
    return held;
  }

  template <class T>
  void initial(T* y) const {
    y[0] = T(0), y[1] = T(v0);
  }
  template <class T>
  void acceleration(const T&, const T*, T* a) const {
    a[0] = direction == 0 ? T(0) : direction > 0 ? T(pull - mu * g) : T(pull + mu * g);
  }
  template <class T>
  void rhs(const T& t, const T* y, T* dydt) const {
    dydt[0] = y[1];
    acceleration(t, y, &dydt[1]);
  }
  template <class T>
  void event_values(const T&, const T* y, T* value) const {
    value[0] = direction > 0 ? y[1] : T(1);
  }
  template <class T>
  std::size_t after_event(std::size_t, const T&, T* y) const {
    y[1] = T(0);
    return holds() ? 1 : 2;
  }

  /// The exact flow: y0 with v > 0 is the state at t = 0.
  template <class T>
  void exact(const T& t, const T* y0, T* y) const {
    exact(t, y0, y, [](std::size_t, const T&) {});
  }
  template <class T, class Visit>
  void exact(const T& t, const T* y0, T* y, Visit&& visit) const {
    const T slowing = -T(pull - mu * g), v = y0[1];
    if (!(slowing > 0) || t * slowing < v) {
      y[0] = y0[0] + t * (v - slowing * t / 2), y[1] = v - slowing * t;
      return;
    }
    const T stop = v / slowing, left = t - stop, back = holds() ? T(0) : T(pull + mu * g);
    visit(0, stop);
    y[0] = y0[0] + v * stop / 2 + back * left * left / 2;
    y[1] = back * left;
  }

 private:
  bool holds() const { return pull <= mu * g && -pull <= mu * g; }
};

}  // namespace odemark
