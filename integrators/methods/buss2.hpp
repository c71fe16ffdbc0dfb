#pragma once
#include "integrators/rotation_step.hpp"

namespace odemark {

namespace detail {
/// The momentum rests in space but for the torque, so w follows from the attitude. The rotation is that of
/// w + h/2 w' + h^2/12 w' x w; the torque's impulse is a trapezoid, its second end at a predicted rate.
struct Buss2 {
  template <class Body, class Real>
  void operator()(Body& body, Real t, Real h, Turning<Real>& s) const {
    const Vector3<Real> momentum = body.momentum(s.w), torque = body.torque(t, s);
    const Vector3<Real> slope = body.rate(torque - cross(s.w, momentum));
    const Quaternion<Real> turn =
        rotation_by(h * (s.w + h / Real(2) * slope + h * h / Real(12) * cross(slope, s.w)));
    s.q = s.q * turn;
    const auto into_new_axes = [&](const Vector3<Real>& v) { return turned(conjugate(turn), v); };
    s.w = body.rate(into_new_axes(momentum + h * torque));
    const Vector3<Real> end = body.torque(t + h, s);
    s.w = body.rate(into_new_axes(momentum + h / Real(2) * torque) + h / Real(2) * end);
  }
};
}  // namespace detail

inline constexpr RotationStep<detail::Buss2> buss2{
    .id = "buss2",
    .source =
        "S. R. Buss, Accurate and efficient simulation of rigid-body rotations, J. Comput. Phys. 164 (2000) "
        "377-406, doi:10.1006/jcph.2000.6602 (augmented second-order method)",
    .order = 2,
    .note = "keeps the angular momentum in space to round-off",
    .advice = "bodies that tumble freely, two torques a step; not for long runs where energy must not drift",
};

}  // namespace odemark
