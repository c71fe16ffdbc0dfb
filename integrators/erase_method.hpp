// Compiles a method once per number type against an erased system.
#pragma once

#include "integrators/erased_stepper.hpp"
#include "integrators/grid_sampler.hpp"

namespace odemark {

/// Kinds that choose their own steps (the chapter's listing) offer `drive` instead of a stepper loop.
template <const auto& method, class P>
concept HasDriver = requires(const P& system, const Control& control, typename P::State& y) {
  KindOf<method>::template drive<method>(system, control, 0.0, 1.0, y, NoObserver{});
};

/// The part of a stepper that does not depend on the method: kinds whose methods differ only in a run-time
/// number (the order of a Taylor series) name it, so that the loops are compiled once for all of them.
template <class S>
auto& engine_of(S& stepper) {
  if constexpr (requires { typename S::Engine; })
    return static_cast<typename S::Engine&>(stepper);
  else
    return stepper;
}

/// error_order(), or 0 for a method without an estimate.
template <const auto& method>
constexpr int error_order_if_any() {
  if constexpr (method.embedded_order > 0)
    return error_order<method>();  // the estimate is as good as the worse of the two, whichever is carried on
  else
    return 0;
}

/// One run under either control, in a loop of its own: what is timed.
template <const auto& method, class P>
RunReport solve(const P& system, const Control& control, double t0, double t1, typename P::State& y) {
  if constexpr (HasDriver<method, P>) {
    return KindOf<method>::template drive<method>(system, control, t0, t1, y, NoObserver{});
  } else {
    StepperOf<method, P> named(system, y);
    auto& stepper = engine_of(named);
    if (const auto* fixed = std::get_if<FixedSteps>(&control)) return integrate(stepper, *fixed, t0, t1, y);
    if constexpr (method.embedded_order > 0)
      return integrate(stepper, system, std::get<ErrorControl>(control), error_order<method>(), t0, t1, y);
    return no_error_estimate(t0);
  }
}

/// Of methods that drive themselves; the others share a loop.
template <const auto& method, class T>
RunReport drive_traced(const ErasedSystem<T>& counted, const ErasedSystem<T>& bare, const Control& control,
                       double t0, double t1, std::vector<T>& y, Trace<T>& trace) {
  StepperOf<method, ErasedSystem<T>> between(bare, y);
  ErasedStepper<T> side(engine_of(between));
  GridSampler sampler(side, bare.size, t0, t1, y, trace);
  return KindOf<method>::template drive<method>(counted, control, t0, t1, y, sampler);
}

template <const auto& method, class T>
void with_stepper(const ErasedSystem<T>& system, const std::vector<T>& model, void* context,
                  void (*use)(void*, ErasedStepper<T>)) {
  StepperOf<method, ErasedSystem<T>> stepper(system, model);
  use(context, ErasedStepper<T>(engine_of(stepper)));
}

template <const auto& method, class T>
void set_runs_of(MethodRuns<T>& runs) {
  using E = ErasedSystem<T>;
  if constexpr (Applicable<method, E>) {
    set_runs<T>(runs, with_stepper<method, T>, error_order_if_any<method>());
    if constexpr (requires { KindOf<method>::has_transition; }) runs.transition = nullptr;
    // double is what is timed, in a loop of its own: the same numbers
    if constexpr (std::is_same_v<T, double> || HasDriver<method, E>) runs.solve = solve<method, E>;
    if constexpr (HasDriver<method, E>)
      runs.solve_traced = drive_traced<method, T>, runs.transition = nullptr;
  }
}

template <const auto& method>
AnyMethod erase_method() {
  using Kind = KindOf<method>;
  static_assert(MethodKind<Kind>);
  AnyMethod any;
  any.id = method.id, any.kind = Kind::kind_name, any.source = method.source;
  any.order = method.order, any.embedded_order = method.embedded_order, any.needs = Kind::needs;
  if constexpr (requires { method.more_needs(); }) any.needs |= method.more_needs();
  any.theory = [] { return method.theory(); };
  std::apply([]<class... T>(MethodRuns<T>&... runs) { (set_runs_of<method, T>(runs), ...); }, any.by_type);
  if constexpr (requires { method.order_with_rate_torque; })
    any.order_with_rate_torque = method.order_with_rate_torque;
  if constexpr (requires { method.note; }) any.note = method.note;
  if constexpr (requires { method.advice; }) any.advice = method.advice;
  if constexpr (requires { Kind::solves_equations; }) any.solves_equations = Kind::solves_equations;
  if constexpr (requires { method.propagates_lower; }) any.propagates_lower = method.propagates_lower;
  if constexpr (requires { method.jumps_over_poles; }) any.jumps_over_poles = method.jumps_over_poles;
  any.own_step_control = ChoosesSteps<StepperOf<method, ErasedSystem<double>>>;
  if constexpr (HasDriver<method, ErasedSystem<double>>) {
    any.takes_fixed_steps = Kind::takes_fixed_steps, any.takes_error_control = true;
  } else {
    using S = StepperOf<method, ErasedSystem<double>>;
    any.takes_error_control = method.embedded_order > 0;
    any.compensated = CompensatedStepper<S>;
    any.multistep = HasHistory<S>;
    if constexpr (requires { Kind::starter_id(); }) any.starter = Kind::starter_id();
    if constexpr (requires { method.starter; }) any.starter = method.starter;
  }
  return any;
}

}  // namespace odemark
