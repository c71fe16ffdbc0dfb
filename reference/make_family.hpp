// Erases the type of a family: one instantiation per family, in a unit of its own.
#pragma once

#include <algorithm>
#include <exception>

#include "integrators/dual.hpp"
#include "reference/any_problem.hpp"
#include "reference/configure.hpp"

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

/// The Jacobian by dual numbers: what a hand-written one is tested against, and what stands in for a missing
/// one.
template <class T, class F>
void dual_jacobian(const F& family, T t, const T* y, MatrixView<T> j) {
  using Number = Dual<T, F::size>;
  std::array<Number, F::size> state, slope;
  for (std::size_t i = 0; i < F::size; ++i) state[i] = Number::variable(y[i], i);
  family.rhs(Number(t), state.data(), slope.data());
  for (std::size_t row = 0; row < F::size; ++row)
    for (std::size_t column = 0; column < F::size; ++column) j(row, column) = slope[row].partial[column];
}

/// Column by column, where the size is known at run time only: n evaluations.
template <class T, HasRunTimeSize F>
void dual_jacobian(const F& family, T t, const T* y, MatrixView<T> j) {
  using Number = Dual<T, 1>;
  std::vector<Number> state(y, y + j.size), slope(j.size);
  for (std::size_t column = 0; column < j.size; ++column) {
    state[column] = Number::variable(y[column], 0);
    family.rhs(Number(t), state.data(), slope.data());
    for (std::size_t row = 0; row < j.size; ++row) j(row, column) = slope[row].partial[0];
    state[column] = Number(y[column]);
  }
}

/// df/dt by dual numbers.
template <class T, class F>
void dual_time_derivative(const F& family, T t, const T* y, T* dfdt) {
  using Number = Dual<T, 1>;
  std::array<Number, F::size> state, slope;
  for (std::size_t i = 0; i < F::size; ++i) state[i] = Number(y[i]);
  family.rhs(Number::variable(t, 0), state.data(), slope.data());
  for (std::size_t i = 0; i < F::size; ++i) dfdt[i] = slope[i].partial[0];
}

template <class T, HasRunTimeSize F>
void dual_time_derivative(const F& family, T t, const T* y, T* dfdt) {
  using Number = Dual<T, 1>;
  const std::size_t n = family.size();
  std::vector<Number> state(y, y + n), slope(n);
  family.rhs(Number::variable(t, 0), state.data(), slope.data());
  for (std::size_t i = 0; i < n; ++i) dfdt[i] = slope[i].partial[0];
}

/// Known not to depend on t: what can be recorded has no branches, so one recording tells for all times.
template <class F>
bool is_autonomous_family() {
  if constexpr (HasSwitches<F>) {
    return false;
  } else {
    static const bool known = [] {
      try {
        return !reads_time(record<double>(F{}, size_of_family(F{})));
      } catch (const std::exception&) {
        return false;  // a force that throws while it is recorded
      }
    }();
    return known;
  }
}

/// Column-major storage of a family's size; zeros where a banded family writes nothing.
template <class T, class F>
MatrixView<T> whole_matrix(const F& family, T* column_major) {
  const std::size_t size = size_of_family(family);
  if constexpr (HasBand<F>) std::fill_n(column_major, size * size, T(0));
  return {column_major, size};
}

template <class T, class F>
ErasedSystem<T> erase(const F& family) {
  ErasedSystem<T> s;
  s.self = &family;
  s.size = size_of_family(family);
  s.abilities = abilities_of(family);
  s.rhs_call = [](const void* p, T t, const T* y, T* dydt) { static_cast<const F*>(p)->rhs(t, y, dydt); };
  if constexpr (HasAcceleration<F>) {
    s.velocity_dependent = F::force_depends_on_velocity;
    s.acceleration_call = [](const void* p, T t, const T* y, T* a) {
      static_cast<const F*>(p)->acceleration(t, y, a);
    };
  }
  if constexpr (HasRotation<F>) {
    s.place = {F::rate_at, F::attitude_at};
    s.inertia_call = [](const void* p, T* m) { static_cast<const F*>(p)->inertia(m); };
    s.torque_call = [](const void* p, T t, const T* y, T* torque) {
      static_cast<const F*>(p)->torque(t, y, torque);
    };
  }
  s.jacobian_call = [](const void* p, T t, const T* y, T* column_major) {
    const MatrixView<T> j = whole_matrix<T>(*static_cast<const F*>(p), column_major);
    if constexpr (HasWrittenJacobian<F>)
      static_cast<const F*>(p)->jacobian(t, y, j);
    else
      dual_jacobian(*static_cast<const F*>(p), t, y, j);
  };
  if constexpr (HasBand<F>) {
    static_assert(HasWrittenJacobian<F>, "a banded Jacobian is written by hand");
    if (const MatrixShape shape = shape_of_family(family); !shape.is_dense()) s.band = shape;
    s.band_call = [](const void* p, T t, const T* y, T* band) {
      const F& self = *static_cast<const F*>(p);
      const MatrixShape shape = shape_of_family(self);
      if constexpr (HasAcceleration<F>)
        self.jacobian(t, y, interleaved_view_of(shape, band));
      else
        self.jacobian(t, y, view_of(shape, band));
    };
  }
  s.autonomous = is_autonomous_family<F>();
  s.time_derivative_call = [](const void* p, T t, const T* y, T* dfdt) {
    dual_time_derivative(*static_cast<const F*>(p), t, y, dfdt);
  };
  if constexpr (HasLinear<F>)
    s.linear_part_call = [](const void* p, T* column_major) {
      const F& self = *static_cast<const F*>(p);
      self.template linear_part<T>(whole_matrix<T>(self, column_major));
    };
  s.record_call = [](const void* p) {
    const F& self = *static_cast<const F*>(p);
    return record<T>(self, size_of_family(self));
  };
  return s;
}

/// The family held in each of its phases; nothing where it has only one.
template <class F>
std::vector<F> phases_of(const F& family) {
  std::vector<F> phases;
  std::size_t count = 0;
  if constexpr (HasSwitches<F>) {
    static_assert(!HasJumps<F>, "give a switch by the clock as an event too, where events jump");
    count = family.switch_times().size() + 1;
  } else if constexpr (requires { F::phase_count; }) {
    count = F::phase_count;
  }
  if constexpr (requires { family.during(std::size_t(0)); })
    for (std::size_t phase = 0; phase < count; ++phase) phases.push_back(family.during(phase));
  return phases;
}

/// `phases` are what phases_of gave, `family` stands in where there are none. Both must outlive the view.
template <class T, class F>
Pieces<T> pieces_of(const F& family, const std::vector<F>& phases) {
  Pieces<T> pieces;
  for (const F& phase : phases) pieces.phases.push_back(erase<T>(phase)), pieces.values.push_back(&phase);
  if (phases.empty()) pieces.phases.push_back(erase<T>(family)), pieces.values.push_back(&family);
  if constexpr (HasSwitches<F>) {
    const auto times = family.switch_times();
    pieces.switch_times.assign(times.begin(), times.end());
  }
  if constexpr (HasEvents<F>) {
    pieces.events = F::events.size();
    pieces.values_call = [](const void* p, T t, const T* y, T* g) {
      static_cast<const F*>(p)->event_values(t, y, g);
    };
  }
  if constexpr (HasJumps<F>) {
    pieces.jumps = true;
    pieces.after_call = [](const void* p, std::size_t event, T t, T* y, std::size_t phase) {
      const F& now = *static_cast<const F*>(p);
      if constexpr (std::is_void_v<decltype(now.after_event(event, t, y))>)
        now.after_event(event, t, y);
      else
        phase = now.after_event(event, t, y);
      return phase;
    };
  }
  return pieces;
}

/// A family of run-time size names groups of components: x1, x2, ..., v1, v2, ... of x and v.
template <class F>
ComponentNames component_names(const F& family) {
  if constexpr (HasRunTimeSize<F>)
    return numbered_components(F::component_groups, family.size());
  else
    return {{}, {F::components.begin(), F::components.end()}};
}

template <class F>
AnyProblem make_problem(const F& values, const Preset& preset, const std::vector<Setting>& user) {
  AnyProblem problem;
  name_problem(problem, preset, user);
  problem.family = F::id, problem.title = F::title, problem.equations = F::equations,
  problem.source = F::source;
  for (const auto& p : F::parameters())
    problem.parameters.push_back({p.name, p.unit, p.meaning, p.range, values.*p.member, false});
  struct Held {
    F value;
    std::vector<F> phases;
    ComponentNames components;
  };
  const auto held = std::make_shared<const Held>(Held{values, phases_of(values), component_names(values)});
  problem.components = held->components.all;
  const F* owned = &held->value;
  problem.value = std::shared_ptr<const void>(held, owned);
  problem.t_end = owned->t_end;
  problem.suggested_dt = owned->suggested_dt();
  problem.initial.resize(size_of_family(*owned));
  owned->initial(problem.initial.data());
  const auto scale = owned->scale();
  problem.scale.assign(scale.begin(), scale.end());
  problem.pieces_by_type = {pieces_of<float>(*owned, held->phases), pieces_of<double>(*owned, held->phases),
                            pieces_of<long double>(*owned, held->phases)};
  problem.switch_times = problem.pieces<double>().switch_times;
  if constexpr (HasEvents<F>) problem.event_names.assign(F::events.begin(), F::events.end());
  if constexpr (requires { F::invariant_names; }) {
    problem.invariant_names.assign(F::invariant_names.begin(), F::invariant_names.end());
    problem.invariants_call = [](const void* p, const long double* y, long double* out) {
      static_cast<const F*>(p)->invariants(y, out);
    };
  }
  if constexpr (requires(const double* y) { owned->oscillation(y); })
    problem.oscillation_call = [](const void* p, const double* y) {
      return static_cast<const F*>(p)->oscillation(y);
    };
  problem.abilities = abilities_of(*owned);
  problem.has_exact = HasExact<F>;
  problem.has_written_jacobian = HasWrittenJacobian<F>;
  problem.systems = {erase<float>(*owned), erase<double>(*owned), erase<long double>(*owned)};
  return problem;
}

template <class F>
AnyProblem create_problem(const Preset& preset, const std::vector<Setting>& user) {
  const auto values = configure<F, double>(parse_settings(preset.settings), user, parse_number);
  AnyProblem problem = make_problem(values, preset, user);
  if constexpr (requires { values.homogeneous(); })
    problem.homogeneous =
        std::make_shared<const AnyProblem>(make_problem(values.homogeneous(), preset, user));
  return problem;
}

/// Everything the suite needs to know of a family. `Family` is a class template on its parameter type.
template <template <class> class Family>
AnyFamily make_family() {
  using F = Family<double>;
  AnyFamily family;
  family.id = F::id, family.title = F::title, family.equations = F::equations, family.source = F::source;
  static const ComponentNames components = component_names(F{});
  family.components = components.all;
  family.presets.assign(F::presets.begin(), F::presets.end());
  const F defaults{};
  for (const auto& p : F::parameters())
    family.parameters.push_back({p.name, p.unit, p.meaning, p.range, defaults.*p.member, false});
  if constexpr (requires { F::shorthands(); })
    for (const auto& s : F::shorthands())
      family.parameters.push_back({s.name, s.unit, s.meaning, s.range, 0, true});
  if constexpr (requires { F::invariant_names; })
    family.invariant_names.assign(F::invariant_names.begin(), F::invariant_names.end());
  if constexpr (HasEvents<F>) family.event_names.assign(F::events.begin(), F::events.end());
  family.abilities = abilities_of(F{});
  family.has_exact = HasExact<F>;
  family.create = create_problem<F>;
  return family;
}

}  // namespace odemark
