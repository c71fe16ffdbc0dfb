#pragma once
#include "integrators/rotation_step.hpp"

namespace odemark {

namespace detail {
/// Kinetic energy in three parts, each of which turns the body about one axis at a constant rate: half of
/// each, the torque's kick in the middle, the halves in reverse.
struct RigidBodySplitting {
  template <class Body, class Real>
  void operator()(Body& body, Real t, Real h, Turning<Real>& s) const {
    const Real half = h / Real(2);
    for (std::size_t axis = 0; axis < 3; ++axis) turn(body, axis, half, s);
    s.w = s.w + h * body.rate(body.torque(t + half, s));
    for (std::size_t axis = 3; axis-- > 0;) turn(body, axis, half, s);
  }

 private:
  /// The momentum rests in space while the body turns by w_axis h: in the body it turns the other way.
  template <class Body, class Real>
  static void turn(const Body& body, std::size_t axis, Real h, Turning<Real>& s) {
    using std::cos, std::sin;
    const std::size_t j = (axis + 1) % 3, k = (axis + 2) % 3;
    const Real angle = h * s.w[axis], c = cos(angle), si = sin(angle);
    const Real lj = body.inertia[j] * s.w[j], lk = body.inertia[k] * s.w[k];
    s.w[j] = (c * lj + si * lk) / body.inertia[j];
    s.w[k] = (c * lk - si * lj) / body.inertia[k];
    Vector3<Real> vector{};
    vector[axis] = angle;
    s.q = s.q * rotation_by(vector);
  }
};
}  // namespace detail

inline constexpr RotationStep<detail::RigidBodySplitting> rigid_body_splitting{
    .id = "rigid_body_splitting",
    .source =
        "A. Dullweber, B. Leimkuhler, R. McLachlan, J. Chem. Phys. 107 (1997) 5840-5851, "
        "doi:10.1063/1.474310; "
        "J. Touma, J. Wisdom, Astron. J. 107 (1994) 1189-1202, doi:10.1086/116931",
    .order = 2,
    .order_with_rate_torque = 1,
    .note = "keeps the momentum in space to round-off and the energy within a bound",
    .advice = "molecules, satellites, free tumbling for ever; not with strong damping torques",
};

}  // namespace odemark
