// A ship with quadratic drag whose propeller is put into reverse: a switch in time and a kink in the state.
#pragma once
#include <algorithm>

#include "problems/family.hpp"

namespace odemark {

/// State (s, v). The thrust is `thrust` before t_reverse and -thrust from then on. The force v|v| has a jump
/// in its second derivative where the ship stands still, which the closed form knows and a driver does not.
template <class Real = double>
struct DragShipQuadratic {
  static constexpr std::string_view id = "drag_ship_quadratic";
  static constexpr std::string_view title = "Ship with quadratic drag and thrust reversal";
  static constexpr std::string_view equations =
      "s' = v;  v' = (F - c v |v|)/m,  F = thrust for t < t_reverse, -thrust after";
  static constexpr std::string_view source =
      "E4 of DETEST, T. E. Hull et al., SIAM J. Numer. Anal. 9 (1972) 603-637, doi:10.1137/0709052; "
      "here in SI units and with the propeller put into reverse";
  static constexpr std::size_t size = 2;
  static constexpr std::array<Component, size> components{{{"s", "m"}, {"v", "m/s"}}};
  static constexpr std::array<std::string_view, 2> events{"stands still, was going ahead",
                                                          "stands still, was going astern"};
  static constexpr bool force_depends_on_velocity = true;

  Real thrust = 1000000, c = 25000, m = 5000000, t_reverse = 60, s0 = 0, v0 = 0, t_end = 120;

  static constexpr auto parameters() {
    using P = Parameter<DragShipQuadratic, Real>;
    return std::array{P{"thrust", "N", "propeller thrust before it is reversed", &DragShipQuadratic::thrust},
                      P{"c", "kg/m", "drag coefficient", &DragShipQuadratic::c, positive},
                      P{"m", "kg", "mass", &DragShipQuadratic::m, positive},
                      P{"t_reverse", "s", "the instant the thrust is reversed", &DragShipQuadratic::t_reverse,
                        not_negative},
                      P{"s0", "m", "initial position", &DragShipQuadratic::s0},
                      P{"v0", "m/s", "initial speed", &DragShipQuadratic::v0},
                      P{"t_end", "s", "end of the interval", &DragShipQuadratic::t_end, positive}};
  }
  static constexpr std::array presets{
      Preset{"drag_ship_quadratic", "", "ahead for 60 s, then astern; stands still at 84.1 s"},
      Preset{"drag_ship_quadratic_ahead", "t_reverse=240", "never reversed: smooth throughout"},
      Preset{"drag_ship_quadratic_crash_stop", "v0=8,t_reverse=0",
             "astern from the start; stands still at 28.5 s"}};

  std::array<double, size> scale() const {
    const double limit = std::sqrt(std::abs(double(thrust)) / double(c)),
                 v = std::max(limit, std::abs(double(v0)));
    return v > 0 ? std::array<double, size>{v * double(t_end), v} : std::array<double, size>{1, 1};
  }
  double suggested_dt() const { return 0.5; }

  /// The instants at which the right-hand side jumps; those outside the interval are of no concern.
  std::array<double, 1> switch_times() const { return {double(t_reverse)}; }
  /// The smooth problem of phase n: before the first switch (0), after it (1). Who stops at a switch
  /// continues with the next phase; the last stage of a step that ends on a switch then still sees the force
  /// of its own phase.
  DragShipQuadratic during(std::size_t phase) const {
    DragShipQuadratic held = *this;
    held.t_reverse =
        phase == 0 ? std::numeric_limits<Real>::infinity() : Real(-std::numeric_limits<Real>::infinity());
    return held;
  }

  /// Where v|v| has its kink. Nothing else happens there.
  template <class T>
  void event_values(const T&, const T* y, T* value) const {
    value[0] = y[1], value[1] = -y[1];
  }

  template <class T>
  void initial(T* y) const {
    y[0] = T(s0), y[1] = T(v0);
  }
  template <class T>
  void acceleration(const T& t, const T* y, T* a) const {
    using std::abs;
    const T& v = y[1];
    a[0] = step_at(t, t_reverse, Real(1), Real(-1)) * (T(thrust) / T(m)) - (T(c) / T(m)) * v * abs(v);
  }
  template <class T>
  void rhs(const T& t, const T* y, T* dydt) const {
    dydt[0] = y[1];
    acceleration(t, y, &dydt[1]);
  }
  template <class T, class J>
  void jacobian(const T&, const T* y, J&& j) const {
    using std::abs;
    j(0, 0) = T(0), j(0, 1) = T(1);
    j(1, 0) = T(0), j(1, 1) = -2 * (T(c) / T(m)) * abs(y[1]);
  }

  /// The exact flow for t >= 0: y0 is the state at t = 0.
  template <class T>
  void exact(const T& t, const T* y0, T* y) const {
    exact(t, y0, y, [](std::size_t, const T&) {});
  }
  template <class T, class Visit>
  void exact(const T& t, const T* y0, T* y, Visit&& visit) const {
    const T ahead = std::clamp(T(t_reverse), T(0), t);
    y[0] = y0[0], y[1] = y0[1];
    push(T(thrust), ahead, y, [&](const T& after) { visit(thrust < 0 ? 0 : 1, after); });
    push(T(-thrust), T(t - ahead), y, [&](const T& after) { visit(thrust < 0 ? 1 : 0, T(ahead + after)); });
  }

 private:
  /// Advances y by the time t under a constant force. In units of the limiting speed r' = 1 - r|r|: a tangent
  /// until the ship stands still, a hyperbolic tangent after.
  template <class T, class Visit>
  void push(const T& force, T t, T* y, Visit&& visit) const {
    using std::abs, std::atan, std::cos, std::expm1, std::log1p, std::sin, std::sinh, std::sqrt, std::tanh;
    const T length = T(m) / T(c);
    if (force == 0) {
      const T slowing = t * abs(y[1]) / length;
      y[0] += (y[1] < 0 ? -length : length) * log1p(slowing);
      y[1] /= 1 + slowing;
      return;
    }
    const T limit = (force < 0 ? -1 : 1) * sqrt(abs(force) / T(c)), rate = abs(limit) / length;
    const T forward = limit < 0 ? T(-length) : length;
    T r = y[1] / limit;
    if (r < 0) {
      const T standstill = atan(-r) / rate, u = rate * std::min(t, standstill);
      const T co = cos(u), si = sin(u), half = sin(u / 2);
      y[0] -= forward * log1p(-2 * half * half - r * si);
      r = t < standstill ? T((r * co + si) / (co - r * si)) : T(0);
      y[1] = limit * r;
      if (t <= standstill) return;
      visit(standstill);
      t -= standstill;
    }
    const T u = rate * t, th = tanh(u);
    if (u < 1) {  // log(cosh u + r sinh u) without cancellation
      const T half = sinh(u / 2);
      y[0] += forward * log1p(2 * half * half + r * sinh(u));
    } else {  // and without overflow
      y[0] += forward * (u + log1p((1 - r) / 2 * expm1(-2 * u)));
    }
    y[1] = limit * ((r + th) / (1 + r * th));
  }
};

}  // namespace odemark
