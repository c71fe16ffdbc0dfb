// The loops that carry a stepper from t0 to t1. Nothing here throws, allocates per step or prints.
#pragma once

#include <cmath>
#include <limits>
#include <string_view>

#include "integrators/step_control.hpp"
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
  if (steps.compensated && !CompensatedStepper<S>) {
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

/// First step from the size of the slope and the tolerance: h such that h |f| is a hundredth of the weights'
/// distance, never more than a hundredth of the interval (a simplified form of HNW I, II.4).
template <class P>
double first_step(const P& system, const ErrorControl& control, double t0, double t1,
                  const typename P::State& y) {
  using Real = RealOf<typename P::State>;
  if (control.first_step > 0) return control.first_step;
  typename P::State slope = zeros_like(y);
  system.rhs(Real(t0), y, slope);
  double size = 0, speed = 0;
  for_each_component(y, [&](std::size_t i) {
    const double weight = error_weight(control, i, std::abs(double(y.data()[i])));
    const double a = double(y.data()[i]) / weight, b = double(slope.data()[i]) / weight;
    size += a * a, speed += b * b;
  });
  const double h = speed > 0 ? 0.01 * std::sqrt(std::max(size, 1.0) / speed) : (t1 - t0) / 100;
  return std::isfinite(h) && h > 0 ? std::min(h, (t1 - t0) / 100) : (t1 - t0) / 100;
}

/// Two estimates are weighed against each other: |e|^2 / sqrt(|e|^2 + 0.01 |e'|^2), so that one that happens
/// to vanish does not deceive (E. Hairer, S. P. Norsett, G. Wanner, Solving ODEs I, II.10).
inline double combined_error_norm(double norm, double second) {
  const double both = std::sqrt(norm * norm + 0.01 * second * second);
  return both == 0 ? 0 : norm * (norm / both);
}
template <class S>
double error_norm_of(const S& stepper, const typename S::State& error, const typename S::State& y,
                     const typename S::State& next, const ErrorControl& control) {
  if constexpr (requires { stepper.second_error(); })
    return combined_error_norm(error_norm(error, y, next, control),
                               error_norm(stepper.second_error(), y, next, control));
  else
    return error_norm(error, y, next, control);
}

/// Error-controlled steps. `error_order` is the order of the error estimate, embedded order + 1.
template <Stepper S, class P, class Observer = NoObserver>
RunReport integrate(S& stepper, const P& system, const ErrorControl& control, int error_order, double t0,
                    double t1, typename S::State& y, Observer&& observe = {}) {
  using Real = RealOf<typename S::State>;
  StepSizeFilter filter(control, error_order);
  typename S::State next = blank_like(y), error = zeros_like(y);
  RunReport report;
  Real t = Real(t0), h = Real(first_step(system, control, t0, t1, y));
  const auto stop = [&](RunStatus status) {
    report.status = status;
    report.t_reached = double(t);
    report.newton = newton_counts_of(stepper);
    return report;
  };
  stepper.start();
  bool newton_failed = false;
  while (t < Real(t1)) {
    if (report.accepted + report.rejected >= control.step_limit) return stop(RunStatus::step_limit);
    if (!(h > std::numeric_limits<Real>::epsilon() * std::abs(t)) ||
        !(h > std::numeric_limits<Real>::min())) {
      if (!all_finite(y)) return stop(RunStatus::not_finite);
      return stop(newton_failed ? RunStatus::newton_diverged : RunStatus::step_underflow);
    }
    // stretch the last step a little rather than leave a sliver
    const bool last = t + h * Real(1.0001) >= Real(t1);
    if (last) h = Real(t1) - t;
    newton_failed = stepper.attempt(t, y, h, next, error) != StepStatus::ok;
    const double norm = newton_failed ? std::numeric_limits<double>::quiet_NaN()
                                      : error_norm_of(stepper, error, y, next, control);
    const Real factor = Real(filter.next_factor(norm));
    if (norm <= 1) {
      stepper.accept();
      const Real t_next = last ? Real(t1) : t + h;
      ++report.accepted;
      const bool go_on = observe(t, y, t_next, next);
      std::swap(y, next);
      t = t_next;
      if (!go_on) return stop(RunStatus::time_limit);
    } else {
      ++report.rejected;
    }
    h *= factor;
  }
  return stop(all_finite(y) ? RunStatus::reached_end : RunStatus::not_finite);
}

}  // namespace odemark
