// A family seen as a system whose right-hand side is inlined into the step.
#pragma once

#include "integrators/dual.hpp"
#include "integrators/system.hpp"
#include "integrators/tape.hpp"
#include "reference/make_family.hpp"

namespace odemark {

/// State is std::array<T, size>. The family is held by value: its parameters can then live in registers.
template <class F, class T>
struct FamilySystem {
  using State = std::array<T, F::size>;
  F family;
  bool autonomous = is_autonomous_family<F>();

  void rhs(T t, const State& y, State& dydt) const { family.rhs(t, y.data(), dydt.data()); }
  void acceleration(T t, const State& y, T* a) const requires HasAcceleration<F> {
    family.acceleration(t, y.data(), a);
  }
  static constexpr bool force_depends_on_velocity() requires HasAcceleration<F> {
    return F::force_depends_on_velocity;
  }
  void jacobian(T t, const State& y, MatrixView<T> j) const {
    if constexpr (HasWrittenJacobian<F>)
      family.jacobian(t, y.data(), j);
    else
      dual_jacobian(family, t, y.data(), j);
  }
  void time_derivative(T t, const State& y, State& dfdt) const {
    dual_time_derivative(family, t, y.data(), dfdt.data());
  }
  void linear_part(MatrixView<T> l) const requires HasLinear<F> { family.template linear_part<T>(l); }
  static constexpr BodyPlace body_place() requires HasRotation<F> { return {F::rate_at, F::attitude_at}; }
  void inertia(T* principal_moments) const requires HasRotation<F> { family.inertia(principal_moments); }
  void torque(T t, const State& y, T* out) const requires HasRotation<F> { family.torque(t, y.data(), out); }
  Tape<T> tape() const { return record<T>(family, F::size); }
  void count_series() const {}
};

}  // namespace odemark
