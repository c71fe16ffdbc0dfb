// Compiles a method once per number type against an erased system.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "integrators/any_method.hpp"

namespace odemark {

/// Kinds that choose their own steps (the chapter's listing) offer `drive` instead of a stepper loop.
template <const auto& method, class P>
concept HasDriver = requires(const P& system, const Control& control, typename P::State& y) {
  KindOf<method>::template drive<method>(system, control, 0.0, 1.0, y, NoObserver{});
};

/// One run under either control. A method without an estimate under error control is not applicable.
template <const auto& method, class P, class Observer = NoObserver>
RunReport solve(const P& system, const Control& control, double t0, double t1, typename P::State& y,
                Observer&& observe = {}) {
  if constexpr (HasDriver<method, P>) {
    return KindOf<method>::template drive<method>(system, control, t0, t1, y, observe);
  } else {
    StepperOf<method, P> stepper(system, y);
    if (const auto* fixed = std::get_if<FixedSteps>(&control))
      return integrate(stepper, *fixed, t0, t1, y, observe);
    if constexpr (method.embedded_order > 0)
      return integrate(stepper, system, std::get<ErrorControl>(control), method.embedded_order + 1, t0, t1, y,
                       observe);
    RunReport report;
    report.status = RunStatus::not_applicable;
    report.reason = "has no error estimate: give a fixed number of steps";
    report.t_reached = t0;
    return report;
  }
}

/// Samples between steps are side steps of the same method from the last accepted state: they have the
/// method's own accuracy and leave the run untouched.
template <const auto& method, class T>
RunReport solve_traced(const ErasedSystem<T>& counted, const ErasedSystem<T>& bare, const Control& control,
                       double t0, double t1, std::vector<T>& y, Trace<T>& trace) {
  using S = StepperOf<method, ErasedSystem<T>>;
  constexpr bool can_side_step = !HasHistory<S>;
  S side(bare, y);
  const std::size_t size = bare.size;
  trace.samples.assign(trace.grid.size() * size, std::numeric_limits<T>::quiet_NaN());
  std::vector<T> between(y), error(y);
  std::size_t next_sample = 0;
  const T close = 8 * std::numeric_limits<T>::epsilon() * std::max(std::abs(T(t0)), std::abs(T(t1)));
  const auto observe = [&](T t_old, const std::vector<T>& y_old, T t_new, const std::vector<T>& y_new) {
    for (; next_sample < trace.grid.size() && T(trace.grid[next_sample]) <= t_new + close; ++next_sample) {
      const T t = T(trace.grid[next_sample]);
      const std::vector<T>* from = &y_new;
      if (t < t_new - close) {
        if (!can_side_step) continue;
        if constexpr (can_side_step) {
          side.start();
          if (side.attempt(t_old, y_old, t - t_old, between, error) != StepStatus::ok) continue;
        }
        from = &between;
      }
      std::copy(from->begin(), from->end(), trace.samples.begin() + std::ptrdiff_t(next_sample * size));
    }
    return !trace.on_step || trace.on_step(t_new, y_new.data());
  };
  return solve<method>(counted, control, t0, t1, y, observe);
}

template <const auto& method, class T>
TransitionMatrix<T> transition(const ErasedSystem<T>& homogeneous, T h) {
  using S = StepperOf<method, ErasedSystem<T>>;
  const std::size_t n = homogeneous.size;
  std::vector<T> y(n, T(0)), next(n, T(0)), error(n, T(0));
  S stepper(homogeneous, y);
  TransitionMatrix<T> matrix;
  std::size_t past = 0;
  if constexpr (HasHistory<S>) past = stepper.history_length();
  matrix.size = n * (1 + past);
  for (std::size_t j = 0; j < matrix.size; ++j) {
    std::fill(y.begin(), y.end(), T(0));
    if (j < n) y[j] = T(1);
    stepper.start();
    if constexpr (HasHistory<S>) {
      stepper.assume_history();
      for (std::size_t k = 0; k < past; ++k)
        for (std::size_t i = 0; i < n; ++i) stepper.history(k)[i] = T(j == n * (1 + k) + i);
    }
    if (stepper.attempt(T(0), y, h, next, error) != StepStatus::ok) matrix.solved = false;
    stepper.accept();
    matrix.columns.insert(matrix.columns.end(), next.begin(), next.end());
    if constexpr (HasHistory<S>)
      for (std::size_t k = 0; k < past; ++k)
        matrix.columns.insert(matrix.columns.end(), stepper.history(k).begin(), stepper.history(k).end());
  }
  return matrix;
}

template <const auto& method, class T>
MethodRuns<T> runs_of() {
  using E = ErasedSystem<T>;
  MethodRuns<T> runs;
  if constexpr (Applicable<method, E>) {
    runs.solve = [](const E& system, const Control& control, double t0, double t1, std::vector<T>& y) {
      return solve<method>(system, control, t0, t1, y);
    };
    runs.solve_traced = solve_traced<method, T>;
    if constexpr (!HasDriver<method, E>) runs.transition = transition<method, T>;
  }
  return runs;
}

template <const auto& method>
AnyMethod erase_method() {
  using Kind = KindOf<method>;
  static_assert(MethodKind<Kind>);
  AnyMethod any;
  any.id = method.id, any.kind = Kind::kind_name, any.source = method.source;
  any.order = method.order, any.embedded_order = method.embedded_order, any.needs = Kind::needs;
  any.theory = [] { return method.theory(); };
  any.by_type = {runs_of<method, float>(), runs_of<method, double>(), runs_of<method, long double>()};
  if constexpr (requires { method.note; }) any.note = method.note;
  if constexpr (HasDriver<method, ErasedSystem<double>>) {
    any.takes_fixed_steps = Kind::takes_fixed_steps, any.takes_error_control = true;
  } else {
    using S = StepperOf<method, ErasedSystem<double>>;
    any.takes_error_control = method.embedded_order > 0;
    any.compensated = CompensatedStepper<S>;
    any.multistep = HasHistory<S>;
    if constexpr (requires { Kind::starter_id(); }) any.starter = Kind::starter_id();
  }
  return any;
}

}  // namespace odemark
