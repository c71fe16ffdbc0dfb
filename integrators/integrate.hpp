// The loops that carry a stepper from t0 to t1. Nothing here throws, allocates per step or prints.
#pragma once

#include <cmath>
#include <limits>
#include <string_view>

#include "integrators/first_step.hpp"
#include "integrators/stepper.hpp"

namespace odemark {

enum class RunStatus {
  reached_end,
  step_limit,       // more steps than the control allows
  step_underflow,   // the step shrank until t + h == t
  not_finite,       // the state became NaN or infinite
  newton_diverged,  // an implicit stage could not be solved
  time_limit,       // the wall-clock limit of the run was reached
  rhs_failed,       // the right-hand side threw
  solver_failed,    // a third-party solver gave up for a reason of its own (see the row's `reason`)
  not_applicable,   // the method cannot run this problem (see the row's `reason`)
};

struct RunReport {
  RunStatus status = RunStatus::reached_end;
  long accepted = 0, rejected = 0;
  double t_reached = 0;
  NewtonCounts newton{};
  std::string_view reason = "";  // static text, where the status alone does not say it
};

/// Called with (t_old, y_old, t_new, y_new) after every accepted step; false stops the run (time_limit).
struct NoObserver {
  template <class T, class S>
  constexpr bool operator()(T, const S&, T, const S&) const {
    return true;
  }
};

template <State S>
bool all_finite(const S& y) {
  using std::isfinite;
  bool finite = true;
  for_each_component(y, [&](std::size_t i) { finite = finite && isfinite(y.data()[i]); });
  return finite;
}

template <class S>
NewtonCounts newton_counts_of(const S& stepper) {
  if constexpr (requires { stepper.newton_counts(); })
    return stepper.newton_counts();
  else
    return {};
}

/// Ties its own iterations to the tolerance.
template <class S>
concept ControlledStepper = Stepper<S> && requires(S s, const ErrorControl& control) {
  s.start(control);
};
/// Changes the factor that the filter wished, because it knows what else a step size costs than its error.
template <class S>
concept AdvisesOnSteps = ControlledStepper<S> && requires(S s, RealOf<typename S::State> wished) {
  { s.choose_factor(wished, 0.5) } -> std::same_as<RealOf<typename S::State>>;
};
/// Has a controller of its own; the filter is not asked.
template <class S>
concept ChoosesSteps = ControlledStepper<S> && requires(S s, RealOf<typename S::State> h) {
  { s.own_factor(h, 0.5) } -> std::same_as<RealOf<typename S::State>>;
};

/// What a stepper can do: known at compile time, or asked of one whose type is gone (ErasedStepper::can).
template <class S>
constexpr bool can_compensate(const S& stepper) {
  if constexpr (requires { stepper.can(); })
    return stepper.can().compensated;
  else
    return CompensatedStepper<S>;
}
template <class S>
constexpr bool is_controlled(const S& stepper) {
  if constexpr (requires { stepper.can(); })
    return stepper.can().controlled;
  else
    return ControlledStepper<S>;
}
template <class S>
constexpr bool chooses_steps(const S& stepper) {
  if constexpr (requires { stepper.can(); })
    return stepper.can().choose_steps;
  else
    return ChoosesSteps<S>;
}
template <class S>
constexpr bool has_second_error(const S& stepper) {
  if constexpr (requires { stepper.can(); })
    return stepper.can().second_error;
  else
    return requires { stepper.second_error(); };
}
template <class S>
constexpr bool keeps_history(const S& stepper) {
  if constexpr (requires { stepper.can(); })
    return stepper.can().history;
  else
    return HasHistory<S>;
}

namespace detail {

template <Stepper S, class Observer>
[[gnu::always_inline]] inline RunReport take_equal_steps(S& stepper, FixedSteps steps, double t0, double t1,
                                                         typename S::State& y_in_out, Observer& observe) {
  using State = typename S::State;
  using Real = RealOf<State>;
  const Real begin = Real(t0), h = (Real(t1) - begin) / Real(steps.count);
  State y = y_in_out, next = blank_like(y), error = blank_like(y), carry = zeros_like(y),
        next_carry = zeros_like(y);
  RunReport report;
  const auto stop = [&](RunStatus status, Real t) {
    y_in_out = y;
    report.status = status;
    report.t_reached = double(t);
    report.newton = newton_counts_of(stepper);
    return report;
  };
  if (steps.compensated && !can_compensate(stepper)) {
    report.reason = "has no compensated summation";
    return stop(RunStatus::not_applicable, begin);
  }
  stepper.start();
  for (long n = 0; n < steps.count; ++n) {
    const Real t = begin + Real(n) * h;
    StepStatus status = StepStatus::ok;
    if constexpr (CompensatedStepper<S>) {
      if (steps.compensated) {
        status = stepper.attempt_compensated(t, y, carry, h, next, next_carry);
        std::swap(carry, next_carry);
      } else {
        status = stepper.attempt(t, y, h, next, error);
      }
    } else {
      status = stepper.attempt(t, y, h, next, error);
    }
    if (status != StepStatus::ok)
      return stop(all_finite(y) ? RunStatus::newton_diverged : RunStatus::not_finite, t);
    stepper.accept();
    ++report.accepted;
    if (!observe(t, y, n + 1 == steps.count ? Real(t1) : begin + Real(n + 1) * h, next)) {
      std::swap(y, next);
      return stop(RunStatus::time_limit, begin + Real(n + 1) * h);
    }
    if constexpr (fixed_size < State >> 0)
      y = next;
    else
      std::swap(y, next);
  }
  return stop(all_finite(y) ? RunStatus::reached_end : RunStatus::not_finite, Real(t1));
}

}  // namespace detail

/// Equal steps on t0 + n (t1 - t0) / count: times are computed, never accumulated. For a state of fixed size
/// the state travels in a local and the loop is inlined into its caller, so that stepper and state live in
/// registers.
template <Stepper S, class Observer = NoObserver>
requires(fixed_size<typename S::State> > 0)  //
    [[gnu::always_inline]] inline RunReport integrate(S& stepper, FixedSteps steps, double t0, double t1,
                                                      typename S::State& y, Observer&& observe = {}) {
  return detail::take_equal_steps(stepper, steps, t0, t1, y, observe);
}
template <Stepper S, class Observer = NoObserver>
RunReport integrate(S& stepper, FixedSteps steps, double t0, double t1, typename S::State& y,
                    Observer&& observe = {}) {
  return detail::take_equal_steps(stepper, steps, t0, t1, y, observe);
}

/// Two estimates are weighed against each other: |e|^2 / sqrt(|e|^2 + 0.01 |e'|^2), so that one that happens
/// to vanish does not deceive (E. Hairer, S. P. Norsett, G. Wanner, Solving ODEs I, II.10). Squares in,
/// square out.
inline double combined_square(double square, double second) {
  const double both = square + 0.01 * second;
  return both == 0 ? 0 : square * (square / both);
}
template <class S, class Floors>
[[gnu::always_inline]] inline double mean_square_of(const S& stepper, const typename S::State& error,
                                                    const typename S::State& y, const typename S::State& next,
                                                    double relative, const Floors& floors) {
  if constexpr (requires { stepper.second_error(); })
    if (has_second_error(stepper))
      return combined_square(mean_square_error(error, y, next, relative, floors),
                             mean_square_error(stepper.second_error(), y, next, relative, floors));
  return mean_square_error(error, y, next, relative, floors);
}

namespace detail {
template <Stepper S, class P, class Observer>
[[gnu::always_inline]] inline RunReport take_controlled_steps(S& stepper, const P& system,
                                                              const ErrorControl& control, int error_order,
                                                              double t0, double t1,
                                                              typename S::State& y_in_out,
                                                              Observer& observe) {
  using State = typename S::State;
  using Real = RealOf<State>;
  StepSizeFilter filter(control, error_order);
  State y = y_in_out, next = blank_like(y), error = zeros_like(y);
  auto floors = [&] {
    if constexpr (fixed_size < State >> 0)
      return std::array<double, fixed_size<State>>{};
    else
      return std::vector<double>(size_of(y));
  }();
  for (std::size_t i = 0; i < size_of(y); ++i) floors[i] = error_weight(control, i, 0);
  const double relative = control.relative_tolerance;
  const Real end = Real(t1);
  RunReport report;
  Real t = Real(t0), h = Real(first_step(system, control, error_order, t0, t1, y));
  const auto stop = [&](RunStatus status) {
    y_in_out = y;
    report.status = status;
    report.t_reached = double(t);
    report.newton = newton_counts_of(stepper);
    return report;
  };
  if constexpr (ControlledStepper<S>)
    stepper.start(control);
  else
    stepper.start();
  bool newton_failed = false;
  while (t < end) {
    if (report.accepted + report.rejected >= control.step_limit) return stop(RunStatus::step_limit);
    if (!(h > std::numeric_limits<Real>::epsilon() * std::abs(t)) ||
        !(h > std::numeric_limits<Real>::min())) {
      if (!all_finite(y)) return stop(RunStatus::not_finite);
      return stop(newton_failed ? RunStatus::newton_diverged : RunStatus::step_underflow);
    }
    // stretch the last step a little rather than leave a sliver
    const bool last = t + h * Real(1.0001) >= end;
    if (last) h = end - t;
    newton_failed = stepper.attempt(t, y, h, next, error) != StepStatus::ok;
    const double square = newton_failed ? std::numeric_limits<double>::quiet_NaN()
                                        : mean_square_of(stepper, error, y, next, relative, floors);
    const auto change_step = [&] {
      Real factor{};
      if (chooses_steps(stepper)) {
        if constexpr (ChoosesSteps<S>) factor = stepper.own_factor(h, std::sqrt(square));
      } else {
        factor = Real(filter.next_factor(square));
      }
      if constexpr (AdvisesOnSteps<S>) factor = stepper.choose_factor(factor, std::sqrt(square));
      h *= factor;
    };
    if (square <= 1) {
      stepper.accept();
      const Real t_next = last ? end : t + h;
      ++report.accepted;
      const bool go_on = observe(t, y, t_next, next);
      if constexpr (fixed_size < State >> 0)
        y = next;
      else
        std::swap(y, next);
      t = t_next;
      if (!go_on) return stop(RunStatus::time_limit);
      if (!is_controlled(stepper) && filter.keeps(square)) [[likely]]
        filter.kept(square);
      else
        change_step();
    } else {
      ++report.rejected;
      change_step();
    }
  }
  return stop(all_finite(y) ? RunStatus::reached_end : RunStatus::not_finite);
}
}  // namespace detail

/// Error-controlled steps. `error_order` is the order of the error estimate, embedded order + 1. As with
/// equal steps, a state of fixed size travels in a local of the caller.
template <Stepper S, class P, class Observer = NoObserver>
requires(fixed_size<typename S::State> > 0)  //
    [[gnu::always_inline]] inline RunReport
    integrate(S& stepper, const P& system, const ErrorControl& control, int error_order, double t0, double t1,
              typename S::State& y, Observer&& observe = {}) {
  return detail::take_controlled_steps(stepper, system, control, error_order, t0, t1, y, observe);
}
template <Stepper S, class P, class Observer = NoObserver>
RunReport integrate(S& stepper, const P& system, const ErrorControl& control, int error_order, double t0,
                    double t1, typename S::State& y, Observer&& observe = {}) {
  return detail::take_controlled_steps(stepper, system, control, error_order, t0, t1, y, observe);
}

}  // namespace odemark
