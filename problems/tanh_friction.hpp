// Dry friction made smooth by a hyperbolic tangent: it does not stick, it creeps, and it is stiff at rest.
#pragma once
#include <algorithm>

#include "problems/family.hpp"

namespace odemark {

/// State (x, v). Where |pull| < grip the block creeps at vs atanh(pull/grip) and the rate there is
/// (grip - pull^2/grip)/vs.
template <class Real = double>
struct TanhFriction {
  static constexpr std::string_view id = "tanh_friction";
  static constexpr std::string_view title = "Block with regularised dry friction";
  static constexpr std::string_view equations = "x' = v;  v' = pull - grip tanh(v/vs)";
  static constexpr std::string_view source =
      "S. Andersson, A. Soderberg, S. Bjorklund, Tribol. Int. 40 (2007) 580-587, "
      "doi:10.1016/j.triboint.2005.11.014";
  static constexpr std::size_t size = 2;
  static constexpr std::array<Component, size> components{{{"x", "m"}, {"v", "m/s"}}};
  static constexpr bool force_depends_on_velocity = true;

  Real pull = 0, grip = 5, vs = Real(1) / 128, v0 = 5, t_end = Real(5) / 4;

  static constexpr auto parameters() {
    using P = Parameter<TanhFriction, Real>;
    return std::array{P{"pull", "m/s^2", "other force per mass, as of a slope", &TanhFriction::pull},
                      P{"grip", "m/s^2", "greatest friction per mass", &TanhFriction::grip, positive},
                      P{"vs", "m/s", "speed at which the friction sets in", &TanhFriction::vs, positive},
                      P{"v0", "m/s", "initial speed", &TanhFriction::v0},
                      P{"t_end", "s", "end of the interval", &TanhFriction::t_end, positive}};
  }
  static constexpr std::array presets{
      Preset{"tanh_friction", "",
             "brakes from 5 m/s in one second, then is at rest and stiff: 640 per second"},
      Preset{"tanh_friction_creeping", "pull=4,v0=0,t_end=4",
             "on a slope that dry friction would hold: it creeps"},
      Preset{"tanh_friction_sliding", "pull=6,v0=0", "on a slope too steep to hold"}};

  std::array<double, size> scale() const {
    const double gained = (std::abs(double(pull)) - double(grip)) * double(t_end);
    const double v = std::max({std::abs(double(v0)), double(vs), gained});
    return {v * double(t_end), v};
  }
  double suggested_dt() const { return 0.25 * double(vs) / double(grip); }

  template <class T>
  void initial(T* y) const {
    y[0] = T(0), y[1] = T(v0);
  }
  template <class T>
  void acceleration(const T&, const T* y, T* a) const {
    using std::tanh;
    a[0] = T(pull) - T(grip) * tanh(y[1] / T(vs));
  }
  template <class T>
  void rhs(const T& t, const T* y, T* dydt) const {
    dydt[0] = y[1];
    acceleration(t, y, &dydt[1]);
  }
  template <class T, class J>
  void jacobian(const T&, const T* y, J&& j) const {
    using std::cosh;
    const T c = cosh(y[1] / T(vs));
    j(0, 0) = T(0), j(0, 1) = T(1);
    j(1, 0) = T(0), j(1, 1) = -T(grip) / T(vs) / c / c;
  }
};

}  // namespace odemark
