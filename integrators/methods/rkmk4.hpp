#pragma once
#include "integrators/rotation_step.hpp"

namespace odemark {

namespace detail {
/// The classical Runge-Kutta method on (w, rotation vector since the start of the step). In the axes of the
/// body q = q_n exp(turn) gives turn' = w + turn x w / 2 + turn x (turn x w) / 12 + O(turn^4), enough for
/// order 4.
struct Rkmk4 {
  template <class Body, class Real>
  void operator()(Body& body, Real t, Real h, Turning<Real>& s) const {
    const Turning<Real> start = s;
    Vector3<Real> turn{}, w_slopes{}, turn_slopes{}, w_slope{}, turn_slope{};
    constexpr int c[4] = {0, 1, 1, 2}, weight[4] = {1, 2, 2, 1};  // in halves, in sixths
    for (int stage = 0; stage < 4; ++stage) {
      const Real reach = h * Real(c[stage]) / Real(2);
      turn = reach * turn_slope;
      s.w = start.w + reach * w_slope;
      s.q = start.q * rotation_by(turn);
      w_slope = body.acceleration(t + reach, s);
      const Vector3<Real> once = cross(turn, s.w);
      turn_slope = s.w + Real(1) / Real(2) * once + Real(1) / Real(12) * cross(turn, once);
      w_slopes = w_slopes + Real(weight[stage]) * w_slope;
      turn_slopes = turn_slopes + Real(weight[stage]) * turn_slope;
    }
    s.w = start.w + h / Real(6) * w_slopes;
    s.q = start.q * rotation_by(h / Real(6) * turn_slopes);
  }
};
}  // namespace detail

inline constexpr RotationStep<detail::Rkmk4> rkmk4{
    .id = "rkmk4",
    .source =
        "H. Munthe-Kaas, High order Runge-Kutta methods on manifolds, Appl. Numer. Math. 29 (1999) 115-127, "
        "doi:10.1016/S0168-9274(98)00030-0",
    .order = 4,
    .note = "the quaternion keeps its length to round-off",
    .advice =
        "accurate attitudes with any torque; not for very long free motion: energy and momentum drift as h^4",
};

}  // namespace odemark
