#pragma once
#include "integrators/rotation_step.hpp"

namespace odemark {

namespace detail {
struct ExponentialMap {
  template <class Body, class Real>
  void operator()(Body& body, Real t, Real h, Turning<Real>& s) const {
    s.w = s.w + h * body.acceleration(t, s);
    s.q = s.q * rotation_by(h * s.w);
  }
};
}  // namespace detail

inline constexpr RotationStep<detail::ExponentialMap> exponential_map{
    .id = "exponential_map",
    .source =
        "F. S. Grassia, Practical parameterization of rotations using the exponential map, J. Graphics Tools "
        "3 "
        "(1998) 29-48, doi:10.1080/10867651.1998.10487493",
    .order = 1,
    .note = "the attitude is exact for a constant angular velocity; the explicit gyroscopic term is not",
    .advice =
        "spinning wheels and balls at any rate; not for unequal moments: the gyroscopic term gains energy",
};

}  // namespace odemark
