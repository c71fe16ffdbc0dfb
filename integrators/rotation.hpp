// Vectors, quaternions and a rigid body: the algebra that rotation methods share.
#pragma once

#include <array>
#include <cmath>

#include "integrators/system.hpp"

namespace odemark {

template <class Real>
struct Vector3 : std::array<Real, 3> {
  friend Vector3 operator+(const Vector3& a, const Vector3& b) {
    return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
  }
  friend Vector3 operator-(const Vector3& a, const Vector3& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
  }
  friend Vector3 operator*(const Real& s, const Vector3& a) { return {s * a[0], s * a[1], s * a[2]}; }
  friend Vector3 cross(const Vector3& a, const Vector3& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  }
  friend Real dot(const Vector3& a, const Vector3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
  /// Component by component: a principal moment or its inverse times a vector.
  friend Vector3 scaled(const Vector3& a, const Vector3& b) {
    return {a[0] * b[0], a[1] * b[1], a[2] * b[2]};
  }
  friend Vector3 divided(const Vector3& a, const Vector3& b) {
    return {a[0] / b[0], a[1] / b[1], a[2] / b[2]};
  }
};

/// Scalar part first.
template <class Real>
struct Quaternion : std::array<Real, 4> {
  friend Quaternion operator*(const Quaternion& p, const Quaternion& q) {
    return {p[0] * q[0] - p[1] * q[1] - p[2] * q[2] - p[3] * q[3],
            p[0] * q[1] + p[1] * q[0] + p[2] * q[3] - p[3] * q[2],
            p[0] * q[2] + p[2] * q[0] + p[3] * q[1] - p[1] * q[3],
            p[0] * q[3] + p[3] * q[0] + p[1] * q[2] - p[2] * q[1]};
  }
  friend Quaternion conjugate(const Quaternion& q) { return {q[0], -q[1], -q[2], -q[3]}; }
  friend Quaternion normalised(const Quaternion& q) {
    using std::sqrt;
    const Real length = sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
    return {q[0] / length, q[1] / length, q[2] / length, q[3] / length};
  }
  /// From body to space, for a unit quaternion.
  friend Vector3<Real> turned(const Quaternion& q, const Vector3<Real>& v) {
    const Quaternion out = q * Quaternion{Real(0), v[0], v[1], v[2]} * conjugate(q);
    return {out[1], out[2], out[3]};
  }
};

/// The rotation by the angle |v| (rad) about v.
template <class Real>
Quaternion<Real> rotation_by(const Vector3<Real>& v) {
  using std::cos, std::sin, std::sqrt;
  const Real angle = sqrt(dot(v, v));
  const Real share = angle == Real(0) ? Real(1) / Real(2) : sin(angle / Real(2)) / angle;
  return {cos(angle / Real(2)), share * v[0], share * v[1], share * v[2]};
}

/// What a rotation method advances: angular velocity along the principal axes, and attitude.
template <class Real>
struct Turning {
  Vector3<Real> w;
  Quaternion<Real> q;
};

/// A problem's body, with room to ask it for torques at states of a method's own.
template <RotatingSystem P>
class RigidBody {
 public:
  using State = typename P::State;
  using Real = RealOf<State>;

  RigidBody(const P& system, const State& model)
      : system_(system), place_(system.body_place()), asked_(model) {
    system.inertia(inertia.data());
  }

  Turning<Real> read(const State& y) const {
    Turning<Real> out;
    for (std::size_t i = 0; i < 3; ++i) out.w[i] = y.data()[place_.rate + i];
    for (std::size_t i = 0; i < 4; ++i) out.q[i] = y.data()[place_.attitude + i];
    return out;
  }
  void write(const Turning<Real>& s, State& y) const {
    for (std::size_t i = 0; i < 3; ++i) y.data()[place_.rate + i] = s.w[i];
    for (std::size_t i = 0; i < 4; ++i) y.data()[place_.attitude + i] = s.q[i];
  }
  /// Along the axes of the body.
  Vector3<Real> torque(Real t, const Turning<Real>& s) {
    write(s, asked_);
    Vector3<Real> out;
    system_.torque(t, asked_, out.data());
    return out;
  }
  Vector3<Real> momentum(const Vector3<Real>& w) const { return scaled(inertia, w); }
  Vector3<Real> rate(const Vector3<Real>& momentum) const { return divided(momentum, inertia); }
  /// Euler's equations: w' = (torque - w x I w) / I.
  Vector3<Real> acceleration(Real t, const Turning<Real>& s) {
    return rate(torque(t, s) - cross(s.w, momentum(s.w)));
  }

  Vector3<Real> inertia;  // principal moments

 private:
  const P& system_;
  BodyPlace place_;
  State asked_;
};

}  // namespace odemark
