// Verlet in the form of games: the last displacement stands in for the velocity, corrected when dt changes.
#pragma once

#include "integrators/theory.hpp"

namespace odemark {

template <const auto& method, SecondOrderSystem P>
class PositionVerletStepper;

/// x+ = x + w h + a(t, x, w) h^2, where w = (x - x_old) / h_old is the mean velocity of the last step; then
/// w+ = w + h a, and the reported velocity is w+ + h/2 a+. The first w is v0 - h/2 a0, a step back along the
/// parabola (published codes take v0 itself, which costs the second order). With w for the velocity this is
/// semi-implicit Euler, whatever the steps do. A force that depends on velocity sees w.
struct PositionVerlet {
  static constexpr std::string_view kind_name = "position Verlet";
  static constexpr unsigned needs = Ability::second_order;
  static constexpr std::string_view starter_id() { return "a parabola backwards"; }

  std::string_view id, source;
  int order = 2;
  int embedded_order = 0;
  std::string_view note = "", advice = "";

  /// Acts on (x, w).
  Theory theory() const {
    using What = SecondOrderMove::What;
    Theory theory;
    theory.moves = {{What::kick, 1}, {What::drift, 1}};
    return theory;
  }

  template <const auto& method, SecondOrderSystem P>
  using Stepper = PositionVerletStepper<method, P>;
};

template <const auto& method, SecondOrderSystem P>
class PositionVerletStepper {
 public:
  using State = typename P::State;
  using Real = RealOf<State>;

  PositionVerletStepper(const P& system, const State& model)
      : system_(system),
        half_(size_of(model) / 2),
        look_(model),
        past_{zeros_like(model), zeros_like(model)},
        new_{past_} {}

  void start() { known_ = false; }
  void accept() {
    known_ = true;
    std::swap(past_, new_);
  }
  /// history(0) is w, history(1) the force that goes with it; both lie where the velocities lie.
  std::size_t history_length() const { return 2; }
  State& history(std::size_t k) { return past_[k]; }
  void assume_history() { known_ = true; }

  StepStatus attempt(Real t, const State& y, Real h, State& next, State&) {
    Real *w = past_[0].data() + half_, *a = past_[1].data() + half_;
    if (!known_) {
      system_.acceleration(t, y, a);
      for (std::size_t i = 0; i < half_; ++i) w[i] = y.data()[half_ + i] - h / Real(2) * a[i];
    }
    Real *w_new = new_[0].data() + half_, *a_new = new_[1].data() + half_;
    for (std::size_t i = 0; i < half_; ++i) {
      w_new[i] = w[i] + h * a[i];
      next.data()[i] = look_.data()[i] = y.data()[i] + h * w_new[i];
      look_.data()[half_ + i] = w_new[i];
    }
    system_.acceleration(t + h, look_, a_new);
    for (std::size_t i = 0; i < half_; ++i) next.data()[half_ + i] = w_new[i] + h / Real(2) * a_new[i];
    return StepStatus::ok;
  }

 private:
  const P& system_;
  std::size_t half_;
  State look_;
  std::array<State, 2> past_, new_;
  bool known_ = false;
};

}  // namespace odemark
