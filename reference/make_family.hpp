// Erases the type of a family: one instantiation per family, in a unit of its own.
#pragma once

#include <algorithm>
#include <exception>

#include "reference/any_problem.hpp"
#include "reference/configure.hpp"
#include "reference/dual_jacobian.hpp"

namespace odemark {

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
