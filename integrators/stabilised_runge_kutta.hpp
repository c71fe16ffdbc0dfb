// Stabilised explicit methods: the number of stages is chosen at every step from h times the spectral radius.
#pragma once

#include <cmath>
#include <limits>

#include "integrators/stabilised_recurrence.hpp"
#include "integrators/theory.hpp"

namespace odemark {

template <const auto& method, System P>
class NamedStabilisedStepper;

struct StabilisedRungeKutta {
  static constexpr std::string_view kind_name = "stabilised Runge-Kutta";
  static constexpr unsigned needs = 0;
  static constexpr bool compiled_apart = true;  // its polynomials: for real numbers only
  /// A step on a linear problem is no fixed matrix: the stages depend on the spectral radius as it is
  /// estimated.
  static constexpr bool has_transition = false;

  std::string_view id, source, note = "", advice = "";
  int order;
  int embedded_order = 0;  // the local error estimate goes with h^(embedded_order + 1)
  StabilisedFamily family;

  Theory theory() const {
    Theory theory;
    theory.blank_reason = "R(z) depends on the number of stages, which is chosen at every step";
    theory.most_stages = stage_cap(family, Coefficient(std::numeric_limits<double>::epsilon()) / 2);
    theory.internal_amplification = odemark::internal_amplification(family, theory.most_stages);
    return theory;
  }
  /// R(z) where the number of stages is given, as coefficients of z^k.
  std::vector<Coefficient> stability_polynomial(std::size_t stages) const {
    return odemark::stability_polynomial(family, stages);
  }

  template <const auto& method, System P>
  requires std::floating_point<ComponentOf<typename P::State>>
  using Stepper = NamedStabilisedStepper<method, P>;
};

/// Which of the methods is a run-time value: one engine serves all. The spectral radius of the Jacobian comes
/// from a nonlinear power iteration at the start and every 25 accepted steps, started from the direction it
/// found last and enlarged by a fifth, as in the RKC code (B. P. Sommeijer, L. F. Shampine, J. G. Verwer, J.
/// Comput. Appl. Math. 88 (1998) 315-326); its evaluations are counted like all others. A step that needs
/// more stages than the cap is refused under error control (its estimate is NaN); with a fixed step it is
/// taken with the cap and may be unstable.
template <System P>
class StabilisedStepper {
 public:
  using State = typename P::State;
  using Real = RealOf<State>;

  StabilisedStepper(const P& system, const State& model, StabilisedFamily family, bool estimates)
      : system_(system),
        family_(family),
        estimates_(estimates),
        cap_(stage_cap(family, std::numeric_limits<Real>::epsilon() / 2)),
        recurrence_(room_for(family)),
        first_(model),
        last_(model),
        before_(model),
        now_(model),
        stage_(model),
        slope_(model),
        direction_(zeros_like(model)) {
    if (family == StabilisedFamily::rock4) ends_.fill(model);
  }

  void start() { first_known_ = radius_known_ = direction_known_ = false; }
  void accept() {
    if (keeps_last()) std::swap(first_, last_);
    first_known_ = keeps_last();
    if (++age_ >= steps_between_estimates) radius_known_ = false;
  }

  StepStatus attempt(Real t, const State& y, Real h, State& next, State& error) {
    if (!first_known_) system_.rhs(t, y, first_);
    first_known_ = true;
    if (!radius_known_) estimate_radius(t, y);
    const Coefficient reach = Coefficient(std::abs(h)) * Coefficient(radius_);
    const std::size_t stages = fixed_stages_ > 0 ? fixed_stages_ : stages_for(family_, reach, cap_);
    if (stages != stages_) fill_recurrence(family_, stages, recurrence_);
    stages_ = stages;
    run_recurrence(t, y, h);
    if (family_ == StabilisedFamily::rock2)
      finish_second_order(t, y, h, next, error);
    else if (family_ == StabilisedFamily::rock4)
      finish_fourth_order(t, y, h, next);
    else
      for_each_component(y, [&](std::size_t i) { next.data()[i] = stage_.data()[i]; });
    if (keeps_last()) estimate(t, y, h, next, error);
    if (estimates_ && fixed_stages_ == 0 && !(reach <= real_interval(family_, stages)))
      for_each_component(y, [&](std::size_t i) { error.data()[i] = std::numeric_limits<Real>::quiet_NaN(); });
    return StepStatus::ok;
  }

  /// As many stages at every step, whatever the spectral radius; 0: chosen again. For measurements.
  void fix_stages(std::size_t stages) { fixed_stages_ = stages; }
  std::size_t stages() const { return stages_; }
  std::size_t cap() const { return cap_; }
  Real spectral_radius() const { return radius_; }

 private:
  static constexpr int steps_between_estimates = 25;

  /// The slope at the end of a step: part of the estimate, and first of the next step.
  bool keeps_last() const { return estimates_ && family_ != StabilisedFamily::rock2; }

  /// Leaves Y_count in stage_ and Y_count - y in now_. Increments are carried, not stages: their rounding
  /// errors are small beside those of y.
  void run_recurrence(Real t, const State& y, Real h) {
    for_each_component(y, [&](std::size_t i) { before_.data()[i] = now_.data()[i] = 0; });
    for (std::size_t j = 1; j <= recurrence_.count; ++j) {
      const RecurrenceStage& c = recurrence_.stages[j];
      const State* slope = &first_;
      if (j > 1) {
        system_.rhs(t + Real(recurrence_.stages[j - 1].node) * h, stage_, slope_);
        slope = &slope_;
      }
      const Real mu = Real(c.mu), nu = Real(c.nu), weight = h * Real(c.slope),
                 at_start = h * Real(c.first_slope);
      for_each_component(y, [&](std::size_t i) {
        const Real fresh = mu * now_.data()[i] + nu * before_.data()[i] + at_start * first_.data()[i] +
                           weight * slope->data()[i];
        before_.data()[i] = now_.data()[i];
        now_.data()[i] = fresh;
        stage_.data()[i] = y.data()[i] + fresh;
      });
    }
    if (recurrence_.count == 0) for_each_component(y, [&](std::size_t i) { stage_.data()[i] = y.data()[i]; });
  }

  /// The two last stages of ROCK2; their difference is the error estimate.
  void finish_second_order(Real t, const State& y, Real h, State& next, State& error) {
    const Coefficient half = recurrence_.last[1] / 2;
    const Real sigma = Real(half), correction = h * Real(half - recurrence_.last[2] / half);
    const Real node = Real(recurrence_.stages[recurrence_.count].node);
    system_.rhs(t + node * h, stage_, slope_);
    for_each_component(y, [&](std::size_t i) {
      now_.data()[i] += h * sigma * slope_.data()[i];
      stage_.data()[i] = y.data()[i] + now_.data()[i];
    });
    system_.rhs(t + (node + sigma) * h, stage_, before_);
    for_each_component(y, [&](std::size_t i) {
      const Real gap = correction * (before_.data()[i] - slope_.data()[i]);
      if (estimates_) error.data()[i] = gap;
      next.data()[i] = y.data()[i] + (now_.data()[i] + h * sigma * before_.data()[i] - gap);
    });
  }

  /// The four last stages of ROCK4, and the slope at the end for the estimate.
  void finish_fourth_order(Real t, const State& y, Real h, State& next) {
    const LastStages& last = recurrence_.finish;
    const Real node = Real(recurrence_.stages[recurrence_.count].node);
    for (std::size_t i = 0; i < 4; ++i) {
      for_each_component(y, [&](std::size_t n) {
        Real sum = 0;
        for (std::size_t j = 0; j < i; ++j) sum += Real(last.a[i][j]) * ends_[j].data()[n];
        stage_.data()[n] = y.data()[n] + (now_.data()[n] + h * sum);
      });
      system_.rhs(t + (node + Real(last.node[i])) * h, stage_, ends_[i]);
    }
    for_each_component(y, [&](std::size_t n) {
      Real sum = 0;
      for (std::size_t i = 0; i < 4; ++i) sum += Real(last.b[i]) * ends_[i].data()[n];
      next.data()[n] = y.data()[n] + (now_.data()[n] + h * sum);
    });
  }
  void estimate_fourth_order(Real h, State& error) {
    const auto& weights = recurrence_.finish.error;
    for_each_component(error, [&](std::size_t n) {
      Real sum = Real(weights[4]) * last_.data()[n];
      for (std::size_t i = 0; i < 4; ++i) sum += Real(weights[i]) * ends_[i].data()[n];
      error.data()[n] = h * sum;
    });
  }

  /// 0.8 (y - y+) + 0.4 h (f + f+), a fifth of 12 times the local error of a smooth solution of second order.
  void estimate(Real t, const State& y, Real h, const State& next, State& error) {
    system_.rhs(t + h, next, last_);
    if (family_ == StabilisedFamily::rock4) return estimate_fourth_order(h, error);
    for_each_component(y, [&](std::size_t i) {
      error.data()[i] =
          Real(0.8L) * (y.data()[i] - next.data()[i]) + Real(0.4L) * h * (first_.data()[i] + last_.data()[i]);
    });
  }

  static Real norm(const State& v) {
    Real sum = 0;
    for_each_component(v, [&](std::size_t i) { sum += v.data()[i] * v.data()[i]; });
    return std::sqrt(sum);
  }

  void estimate_radius(Real t, const State& y) {
    constexpr int most_iterations = 50;
    const Real size = norm(y), root = std::sqrt(std::numeric_limits<Real>::epsilon());
    const Real shift = size > 0 ? size * root : root;
    if (!direction_known_)
      for_each_component(y, [&](std::size_t i) { direction_.data()[i] = first_.data()[i]; });
    Real length = norm(direction_);
    if (!(length > 0)) {
      for_each_component(y, [&](std::size_t i) { direction_.data()[i] = i % 2 ? Real(-1) : Real(1); });
      length = norm(direction_);
    }
    Real radius = 0;
    for (int n = 0; n < most_iterations; ++n) {
      const Real scale = shift / length;
      for_each_component(
          y, [&](std::size_t i) { stage_.data()[i] = y.data()[i] + scale * direction_.data()[i]; });
      system_.rhs(t, stage_, slope_);
      // the shift as it arrived, not as it was meant: rounding is as large as a part of it
      for_each_component(y, [&](std::size_t i) { stage_.data()[i] -= y.data()[i]; });
      const Real taken = norm(stage_);
      for_each_component(y,
                         [&](std::size_t i) { direction_.data()[i] = slope_.data()[i] - first_.data()[i]; });
      length = norm(direction_);
      if (!(length > 0) || !(taken > 0)) break;  // nothing changes in this direction, or NaN
      const Real found = length / taken;
      const bool settled = n > 0 && std::abs(found - radius) <= Real(0.01L) * std::max(found, radius);
      radius = settled || n < most_iterations / 2 ? found : std::max(radius, found);
      if (settled) break;
    }
    radius_ = Real(1.2L) * radius;
    direction_known_ = length > 0;
    radius_known_ = true;
    age_ = 0;
  }

  const P& system_;
  StabilisedFamily family_;
  bool estimates_;
  std::size_t cap_;  // for this number type
  StabilisedRecurrence recurrence_;
  State first_, last_;                  // f(t, y); f at the end of the step
  State before_, now_, stage_, slope_;  // Y_(j-2) - y, Y_(j-1) - y, Y_j, F_j
  State direction_;                     // in which f changes fastest, as far as known
  std::array<State, 4> ends_{};         // slopes of the last stages of ROCK4
  Real radius_ = 0;
  std::size_t stages_ = 0, fixed_stages_ = 0;
  int age_ = 0;
  bool first_known_ = false, radius_known_ = false, direction_known_ = false;
};

template <const auto& method, System P>
class NamedStabilisedStepper : public StabilisedStepper<P> {
 public:
  using Engine = StabilisedStepper<P>;
  NamedStabilisedStepper(const P& system, const typename P::State& model)
      : Engine(system, model, method.family, method.embedded_order > 0) {}
};

}  // namespace odemark
