#pragma once
#include "integrators/rotation_step.hpp"

namespace odemark {

namespace detail {
/// I (w+ - w) + h w+ x I w+ = 0 by one Newton step from w, after the torque's kick; the new rate turns the
/// body.
struct ImplicitGyroscopic {
  template <class Body, class Real>
  void operator()(Body& body, Real t, Real h, Turning<Real>& s) const {
    s.w = s.w + h * body.rate(body.torque(t, s));
    const Vector3<Real>& inertia = body.inertia;
    const Vector3<Real> residual = h * cross(s.w, body.momentum(s.w));
    // columns of d residual / d w: I e_i + h (e_i x I w + w x I e_i)
    Vector3<Real> column[3];
    for (std::size_t i = 0; i < 3; ++i) {
      Vector3<Real> e{};
      e[i] = Real(1);
      const Vector3<Real> moment = scaled(inertia, e);
      column[i] = moment + h * (cross(e, body.momentum(s.w)) + cross(s.w, moment));
    }
    // Cramer's rule
    const Vector3<Real> normal = cross(column[1], column[2]);
    const Real volume = dot(column[0], normal);
    s.w[0] = s.w[0] - dot(residual, normal) / volume;
    s.w[1] = s.w[1] - dot(column[0], cross(residual, column[2])) / volume;
    s.w[2] = s.w[2] - dot(column[0], cross(column[1], residual)) / volume;
    const Quaternion<Real> slope = s.q * Quaternion<Real>{Real(0), s.w[0], s.w[1], s.w[2]};
    for (std::size_t i = 0; i < 4; ++i) s.q[i] = s.q[i] + h / Real(2) * slope[i];
    s.q = normalised(s.q);
  }
};
}  // namespace detail

inline constexpr RotationStep<detail::ImplicitGyroscopic> implicit_gyroscopic{
    .id = "implicit_gyroscopic",
    .source =
        "E. Catto, Numerical Methods, GDC 2015 (gyroscopic torque); Bullet's "
        "btRigidBody::computeGyroscopicImpulseImplicit_Body",
    .order = 1,
    .note = "one Newton step from the old rate",
    .advice =
        "games with spinning rods and plates that must not blow up; not where a free spin must go on: it "
        "loses energy",
};

}  // namespace odemark
