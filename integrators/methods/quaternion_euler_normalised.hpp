#pragma once
#include "integrators/rotation_step.hpp"

namespace odemark {

namespace detail {
struct QuaternionEuler {
  template <class Body, class Real>
  void operator()(Body& body, Real t, Real h, Turning<Real>& s) const {
    s.w = s.w + h * body.acceleration(t, s);
    const Quaternion<Real> slope = s.q * Quaternion<Real>{Real(0), s.w[0], s.w[1], s.w[2]};
    for (std::size_t i = 0; i < 4; ++i) s.q[i] = s.q[i] + h / Real(2) * slope[i];
    s.q = normalised(s.q);
  }
};
}  // namespace detail

inline constexpr RotationStep<detail::QuaternionEuler> quaternion_euler_normalised{
    .id = "quaternion_euler_normalised",
    .source =
        "D. Baraff, An introduction to physically based modeling: rigid body simulation I, SIGGRAPH course "
        "notes, "
        "1997, 4; E. Catto, Numerical Methods, GDC 2015 (new angular velocity first)",
    .order = 1,
    .note = "turns by 2 atan(w h/2) instead of w h: a fast spin lags",
    .advice =
        "slow bodies in games; not for fast spins, nor for unequal moments: the gyroscopic term gains energy",
};

}  // namespace odemark
