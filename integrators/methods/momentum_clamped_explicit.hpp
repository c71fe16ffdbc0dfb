#pragma once
#include "integrators/rotation_step.hpp"

namespace odemark {

namespace detail {
/// The explicit gyroscopic step in the momentum, shrunk back to the length it came from; then the torque's
/// kick.
struct MomentumClamped {
  template <class Body, class Real>
  void operator()(Body& body, Real t, Real h, Turning<Real>& s) const {
    using std::sqrt;
    const Vector3<Real> torque = body.torque(t, s), momentum = body.momentum(s.w);
    Vector3<Real> turned_momentum = momentum - h * cross(s.w, momentum);
    const Real length2 = dot(turned_momentum, turned_momentum);
    if (!(length2 == Real(0))) turned_momentum = sqrt(dot(momentum, momentum) / length2) * turned_momentum;
    s.w = body.rate(turned_momentum + h * torque);
    s.q = s.q * rotation_by(h * s.w);
  }
};
}  // namespace detail

inline constexpr RotationStep<detail::MomentumClamped> momentum_clamped_explicit{
    .id = "momentum_clamped_explicit",
    .source =
        "J. Rouwe, Jolt Physics, MotionProperties::ApplyGyroscopicForceInternal; the same in Avian's "
        "solve_gyroscopic_torque",
    .order = 1,
    .note = "keeps the length of the momentum, neither its direction in space nor the energy",
    .advice =
        "cheap gyroscopic effects in games; not where the motion must be right: energy drifts to an axis",
};

}  // namespace odemark
