// A rigid body with all its six degrees of freedom: it tumbles, and an engine fixed to it pushes where it
// points.
#pragma once
#include <algorithm>
#include <string>

#include "problems/family.hpp"

namespace odemark {

/// State (position, velocity in space; w along the axes of the body; q, scalar first, that turns them into
/// space). The engine pushes along axis 1.
template <class Real = double>
struct RigidBody6Dof {
  static constexpr std::string_view id = "rigid_body_6dof";
  static constexpr std::string_view title = "Rigid body in space";
  static constexpr std::string_view equations =
      "x' = v;  v' = thrust/m (q e1 q*) - g e3;  I w' = I w x w;  q' = q (0, w)/2";
  static constexpr std::string_view source =
      "D. G. Murri, E. B. Jackson, R. O. Shelton, NASA/TM-2015-218675 (2015), case 2 for the brick; B. L. "
      "Stevens, F. L. Lewis, Aircraft Control and Simulation, 2nd ed. (Wiley, 2003), ch. 1";
  static constexpr std::size_t size = 13;
  static constexpr std::array<Component, size> components{{{"x", "m"},
                                                           {"y", "m"},
                                                           {"z", "m"},
                                                           {"vx", "m/s"},
                                                           {"vy", "m/s"},
                                                           {"vz", "m/s"},
                                                           {"w1", "rad/s"},
                                                           {"w2", "rad/s"},
                                                           {"w3", "rad/s"},
                                                           {"q0", ""},
                                                           {"q1", ""},
                                                           {"q2", ""},
                                                           {"q3", ""}}};
  static constexpr std::array<std::string_view, 5> invariant_names{
      "rotation_energy", "momentum_x", "momentum_y", "momentum_z", "norm_squared"};

  Real m = 2, I1 = Real(3) / 1024, I2 = Real(9) / 1024, I3 = Real(10) / 1024, thrust = 0, g = Real(157) / 16;
  Real vx0 = 8, vz0 = 24, w1 = Real(3) / 16, w2 = Real(5) / 16, w3 = Real(1) / 2, t_end = 30;

  static constexpr auto parameters() {
    using P = Parameter<RigidBody6Dof, Real>;
    return std::array{P{"m", "kg", "mass", &RigidBody6Dof::m, positive},
                      P{"I1", "kg m^2", "first principal moment of inertia", &RigidBody6Dof::I1, positive},
                      P{"I2", "kg m^2", "second principal moment of inertia", &RigidBody6Dof::I2, positive},
                      P{"I3", "kg m^2", "third principal moment of inertia", &RigidBody6Dof::I3, positive},
                      P{"thrust", "N", "thrust along axis 1 of the body", &RigidBody6Dof::thrust},
                      P{"g", "m/s^2", "gravity along -z", &RigidBody6Dof::g},
                      P{"vx0", "m/s", "initial speed along x", &RigidBody6Dof::vx0},
                      P{"vz0", "m/s", "initial speed along z", &RigidBody6Dof::vz0},
                      P{"w1", "rad/s", "initial angular velocity about axis 1", &RigidBody6Dof::w1},
                      P{"w2", "rad/s", "initial angular velocity about axis 2", &RigidBody6Dof::w2},
                      P{"w3", "rad/s", "initial angular velocity about axis 3", &RigidBody6Dof::w3},
                      P{"t_end", "s", "end of the interval", &RigidBody6Dof::t_end, positive}};
  }
  static constexpr std::array presets{
      Preset{"rigid_body_6dof", "", "a brick thrown into a vacuum, tumbling like NASA's"},
      Preset{"rigid_body_6dof_thruster", "g=0,thrust=8,vx0=0,vz0=0,w1=1/8,w2=2,w3=1/16,t_end=12",
             "an engine stuck open on a body that flips: the path is the double integral of the attitude"}};

  std::string validate() const {
    return I1 > I2 + I3 || I2 > I3 + I1 || I3 > I1 + I2
               ? "no body has a principal moment of inertia greater than the sum of the other two"
               : "";
  }
  std::array<double, size> scale() const {
    const double w = std::max(std::hypot(double(w1), double(w2), double(w3)), 1e-3);
    const double v = std::max({std::hypot(double(vx0), double(vz0)), std::abs(double(g)) * double(t_end),
                               std::abs(double(thrust)) / double(m) / w, 1e-3});
    return {v * double(t_end), v * double(t_end), v * double(t_end), v, v, v, w, w, w, 1, 1, 1, 1};
  }
  double suggested_dt() const { return 0.0625 / scale()[6]; }

  template <class T>
  void initial(T* y) const {
    for (std::size_t i = 0; i < size; ++i) y[i] = T(0);
    y[3] = T(vx0), y[5] = T(vz0);
    y[6] = T(w1), y[7] = T(w2), y[8] = T(w3), y[9] = T(1);
  }
  template <class T>
  void rhs(const T&, const T* y, T* dydt) const {
    const T &a = y[6], &b = y[7], &c = y[8], push = T(thrust) / T(m);
    const T* q = y + 9;
    for (std::size_t i = 0; i < 3; ++i) dydt[i] = y[i + 3];
    dydt[3] = push * (q[0] * q[0] + q[1] * q[1] - q[2] * q[2] - q[3] * q[3]);
    dydt[4] = 2 * push * (q[1] * q[2] + q[0] * q[3]);
    dydt[5] = 2 * push * (q[1] * q[3] - q[0] * q[2]) - T(g);
    dydt[6] = ((T(I2) - T(I3)) / T(I1)) * b * c;
    dydt[7] = ((T(I3) - T(I1)) / T(I2)) * c * a;
    dydt[8] = ((T(I1) - T(I2)) / T(I3)) * a * b;
    dydt[9] = -(a * q[1] + b * q[2] + c * q[3]) / 2;
    dydt[10] = (a * q[0] + c * q[2] - b * q[3]) / 2;
    dydt[11] = (b * q[0] + a * q[3] - c * q[1]) / 2;
    dydt[12] = (c * q[0] + b * q[1] - a * q[2]) / 2;
  }
  /// The angular momentum in space is turned by q as it is: a quaternion that has grown makes it grow.
  template <class T>
  void invariants(const T* y, T* out) const {
    const T l1 = T(I1) * y[6], l2 = T(I2) * y[7], l3 = T(I3) * y[8];
    const T &p = y[9], &a = y[10], &b = y[11], &c = y[12];
    out[0] = (l1 * y[6] + l2 * y[7] + l3 * y[8]) / 2;
    out[1] = (p * p + a * a - b * b - c * c) * l1 + 2 * (a * b - p * c) * l2 + 2 * (a * c + p * b) * l3;
    out[2] = 2 * (a * b + p * c) * l1 + (p * p - a * a + b * b - c * c) * l2 + 2 * (b * c - p * a) * l3;
    out[3] = 2 * (a * c - p * b) * l1 + 2 * (b * c + p * a) * l2 + (p * p - a * a - b * b + c * c) * l3;
    out[4] = p * p + a * a + b * b + c * c;
  }
};

}  // namespace odemark
