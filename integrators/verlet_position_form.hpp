// Verlet's method as he wrote it, in positions alone, with the right factors where the step changes.
#pragma once

#include "integrators/methods/stormer_verlet.hpp"

namespace odemark {

template <const auto& method, SecondOrderSystem P>
class VerletPositionFormStepper;

/// x_{n+1} = x_n + (x_n - x_{n-1}) h_n / h_{n-1} + a_n h_n (h_n + h_{n-1}) / 2, of which equal steps make
/// 2 x_n - x_{n-1} + h^2 a_n; the velocity reported is (x_{n+1} - x_n) / h_n + a_{n+1} h_n / 2 and steps
/// nothing. In exact arithmetic this is velocity Verlet at any sequence of steps; in floating point the
/// velocity is a difference of positions and carries their rounding, divided by h.
struct VerletPositionForm {
  static constexpr std::string_view kind_name = "Verlet, position form";
  static constexpr unsigned needs = Ability::second_order | Ability::separable;
  static constexpr std::string_view starter_id() { return stormer_verlet.id; }

  std::string_view id, source;
  int order;
  int embedded_order = 0;
  std::string_view note = "", advice = "";

  Theory theory() const {
    using What = SecondOrderMove::What;
    Theory theory;
    theory.moves = {{What::kick, 0.5L}, {What::drift, 1}, {What::kick, 0.5L}};
    return theory;
  }

  template <const auto& method, SecondOrderSystem P>
  using Stepper = VerletPositionFormStepper<method, P>;
};

template <const auto& method, SecondOrderSystem P>
class VerletPositionFormStepper {
 public:
  using State = typename P::State;
  using Real = RealOf<State>;

  VerletPositionFormStepper(const P& system, const State& model)
      : system_(system),
        starter_(system, model),
        half_(size_of(model) / 2),
        before_(model),
        tried_(model),
        a_(zeros_like(model)),
        next_a_(a_) {}

  void start() { position_known_ = acceleration_known_ = false, starter_.start(); }

  StepStatus attempt(Real t, const State& y, Real h, State& next, State& error) {
    tried_ = y, tried_h_ = h;
    if (!position_known_) return starter_.attempt(t, y, h, next, error);
    if (!acceleration_known_) system_.acceleration(t, y, a_.data());
    acceleration_known_ = true;  // still that of (t, y) if this attempt is rejected
    const Real h_before = before_h_ == Real(0) ? h : before_h_, ratio = h / h_before;
    for (std::size_t i = 0; i < half_; ++i) {
      const Real x = y.data()[i];
      next.data()[i] = x + (ratio * (x - before_.data()[i]) + h * ((h + h_before) / Real(2)) * a_.data()[i]);
      next.data()[half_ + i] = y.data()[half_ + i];
    }
    system_.acceleration(t + h, next, next_a_.data());
    for (std::size_t i = 0; i < half_; ++i)
      next.data()[half_ + i] = (next.data()[i] - y.data()[i]) / h + h / Real(2) * next_a_.data()[i];
    return StepStatus::ok;
  }

  void accept() {
    std::swap(before_, tried_);
    before_h_ = tried_h_;
    if (acceleration_known_) std::swap(a_, next_a_);
    position_known_ = true;
  }

  std::size_t history_length() const { return 1; }
  State& history(std::size_t) { return before_; }
  /// ... at the distance of the next step.
  void assume_history() { position_known_ = true, before_h_ = Real(0); }

 private:
  const P& system_;
  StepperOf<stormer_verlet, P> starter_;
  std::size_t half_;
  State before_, tried_, a_, next_a_;  // y_{n-1}; the start of the last attempt; accelerations at n and n + 1
  Real before_h_ = 0, tried_h_ = 0;
  bool position_known_ = false, acceleration_known_ = false;
};

}  // namespace odemark
