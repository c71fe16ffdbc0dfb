// What a family can do and how large it is, read off its members.
#pragma once

#include <algorithm>

#include "integrators/system.hpp"

namespace odemark {

template <class F>
concept HasAcceleration = requires(const F& f, double t, const double* y, double* a) {
  f.acceleration(t, y, a);
};
template <class F>
concept HasWrittenJacobian = requires(const F& f, double t, const double* y, MatrixView<double> j) {
  f.jacobian(t, y, j);
};
template <class F>
concept HasLinear = requires(const F& f, MatrixView<double> l) {
  f.template linear_part<double>(l);
};
template <class F>
concept HasExact = requires(const F& f, long double t, const long double* y0, long double* y) {
  f.exact(t, y0, y);
};

/// The right-hand side jumps at given times.
template <class F>
concept HasSwitches = requires(const F& f) {
  f.switch_times();
};
/// The state decides when something happens.
template <class F>
concept HasEvents = requires(const F& f, double t, const double* y, double* g) {
  F::events;
  f.event_values(t, y, g);
};
/// And then the state or the phase changes.
template <class F>
concept HasJumps = HasEvents<F> && requires(const F& f, double t, double* y) {
  f.after_event(std::size_t(0), t, y);
};
template <class F>
concept HasRotation = requires(const F& f, double t, const double* y, double* out) {
  f.inertia(out);
  f.torque(t, y, out);
};

/// The number of components is a parameter.
template <class F>
concept HasRunTimeSize = requires(const F& f) {
  f.size();
};
/// The Jacobian is banded.
template <class F>
concept HasBand = requires(const F& f) {
  f.bandwidth();
};

template <class F>
std::size_t size_of_family([[maybe_unused]] const F& family) {
  if constexpr (HasRunTimeSize<F>)
    return family.size();
  else
    return F::size;
}

template <class F>
constexpr unsigned abilities_of() {
  unsigned abilities =
      Ability::jacobian | Ability::recordable | Ability::double_precision | Ability::moderate_size;
  if constexpr (HasAcceleration<F>) {
    abilities |= Ability::second_order;
    if (!F::force_depends_on_velocity) abilities |= Ability::separable;
  }
  if constexpr (HasLinear<F>) abilities |= Ability::linear_part;
  if constexpr (HasRotation<F>) {
    static_assert(F::size == 7, "rotation methods advance the seven numbers of one body and nothing else");
    abilities |= Ability::rotation;
  }
  // a right-hand side that switches at given times is no single piece of straight-line code
  if constexpr (HasSwitches<F>) abilities &= ~unsigned(Ability::recordable);
  return abilities;
}

/// What the size takes away: whole matrices, and recordings that keep every operation of the right-hand side.
template <class F>
unsigned abilities_of(const F& family) {
  unsigned abilities = abilities_of<F>();
  const std::size_t size = size_of_family(family);
  if (size > largest_moderate_size) abilities &= ~unsigned(Ability::moderate_size);
  if (size > largest_recorded_size) abilities &= ~unsigned(Ability::recordable);
  return abilities;
}

/// Of a second-order family the band is that of its acceleration, and that of the Jacobian once positions and
/// velocities are taken in turn: x_i stands one place before v_i and two before x_(i+1).
template <class F>
MatrixShape shape_of_family(const F& family) {
  const std::size_t size = size_of_family(family);
  if constexpr (!HasBand<F>) {
    return MatrixShape::dense(size);
  } else {
    const auto [lower, upper] = family.bandwidth();
    if constexpr (HasAcceleration<F>)
      return MatrixShape::band(size, 2 * lower + 1,
                               std::max<std::size_t>(1, 2 * upper - !F::force_depends_on_velocity), true);
    else
      return MatrixShape::band(size, lower, upper, false);
  }
}

}  // namespace odemark
