// What an integrator needs from a problem. A problem satisfies these concepts without including
// anything from this folder.
#pragma once

#include <string>
#include <string_view>

#include "integrators/matrix_shape.hpp"
#include "integrators/state.hpp"

namespace odemark {

/// dy/dt = f(t, y). `rhs` overwrites dydt; it neither allocates, nor keeps references.
template <class P>
concept System = State<typename P::State> &&
    requires(const P& p, RealOf<typename P::State> t, const typename P::State& y, typename P::State& dydt) {
  p.rhs(t, y, dydt);
};

/// x'' = a(t, x, x') on y = (x, x'): positions are the first half of the state, velocities the second.
/// `acceleration` writes size/2 numbers. `force_depends_on_velocity()` false makes the problem a separable
/// Hamiltonian one: kicks are then exact flows and splitting methods symplectic.
template <class P>
concept SecondOrderSystem = System<P> &&
    requires(const P& p, RealOf<typename P::State> t, const typename P::State& y,
             ComponentOf<typename P::State>* a) {
  p.acceleration(t, y, a);
  { p.force_depends_on_velocity() } -> std::convertible_to<bool>;
};

template <class P>
concept HasJacobian = System<P> &&
    requires(const P& p, RealOf<typename P::State> t, const typename P::State& y,
             MatrixView<ComponentOf<typename P::State>> j) {
  p.jacobian(t, y, j);
};

/// f(t, y) = L y + N(t, y) with a constant matrix L that carries the stiffness.
template <class P>
concept HasLinearPart = System<P> && requires(const P& p, MatrixView<ComponentOf<typename P::State>> l) {
  p.linear_part(l);
};

/// Where the state of a rotating body lies: three angular velocities along its principal axes, and the
/// quaternion (scalar first) that turns body vectors into space.
struct BodyPlace {
  std::size_t rate = 0, attitude = 0;
};

/// A rigid body that only turns: I w' = torque - w x I w, q' = q (0, w)/2, with I the three principal moments
/// and the torque along the axes of the body.
template <class P>
concept RotatingSystem = System<P> &&
    requires(const P& p, RealOf<typename P::State> t, const typename P::State& y,
             ComponentOf<typename P::State>* out) {
  { p.body_place() } -> std::same_as<BodyPlace>;
  p.inertia(out);
  p.torque(t, y, out);
};

/// Up to here whole matrices are affordable: 32 MB each.
inline constexpr std::size_t largest_moderate_size = 2000;
/// Up to here recordings and their Taylor series are: a hundred numbers for every operation.
inline constexpr std::size_t largest_recorded_size = 20'000;

/// What a problem can do beyond `rhs`, and so what a method may need. Bits, because where types are erased a
/// pair is decided at run time.
enum Ability : unsigned {
  second_order = 1,
  jacobian = 2,
  linear_part = 4,
  recordable = 8,
  separable = 16,
  double_precision = 32,
  rotation = 64,
  moderate_size = 128,
};

/// The sentence for the first ability that is needed and not had; empty where the pair can run.
inline std::string_view missing_ability(unsigned needed, unsigned had) {
  const unsigned missing = needed & ~had;
  if (missing & Ability::second_order) return "needs a second-order problem x'' = a(t, x, x')";
  if (missing & Ability::separable) return "needs a force that does not depend on velocity";
  if (missing & Ability::jacobian) return "needs a Jacobian";
  if (missing & Ability::linear_part) return "needs a problem that exposes a linear part";
  if (missing & Ability::recordable)
    return "needs a right-hand side that can be recorded for its Taylor series";
  if (missing & Ability::rotation)
    return "needs a rigid body: angular velocity, attitude, inertia and torque";
  if (missing & Ability::double_precision) return "computes in double precision only";
  if (missing & Ability::moderate_size)
    return "computes with whole matrices: takes no more than 2000 components";
  return "";
}

}  // namespace odemark
