// The engines of multistep methods: explicit, implicit by Newton's iteration, and predictor-corrector.
#pragma once

#include "integrators/compensated.hpp"
#include "integrators/implicit_equation.hpp"
#include "integrators/multistep_history.hpp"

namespace odemark {

template <const auto& method, System P>
class MultistepStepper : public MultistepHistory<method, P> {
 public:
  using Base = MultistepHistory<method, P>;
  using State = typename P::State;
  using Real = RealOf<State>;

  MultistepStepper(const P& system, const State& model)
      : Base(system, model), increment_(blank_like(model)) {}

  StepStatus attempt(Real t, const State& y, Real h, State& next, State& error) {
    this->look(t, y);
    if (this->starting()) return this->starter_.attempt(t, y, h, next, error);
    this->template combine_past<Formula>(y, h, next);
    return StepStatus::ok;
  }

  /// Where the formula adds to y_n alone.
  StepStatus attempt_compensated(
      Real t, const State& y, const State& carry, Real h, State& next,
      State& next_carry) requires(CompensatedStepper<typename Base::Starter>&& method.formula.states[0] ==
                                  1) {
    this->look(t, y);
    if (this->starting()) return this->starter_.attempt_compensated(t, y, carry, h, next, next_carry);
    this->template add_slopes<Formula>(y, h, increment_, [](std::size_t) { return ComponentOf<State>(0); });
    add_compensated(y, carry, increment_, next, next_carry);
    return StepStatus::ok;
  }

 private:
  struct Formula {
    static constexpr const auto& formula = method.formula;
  };
  State increment_;
};

template <const auto& method, System P>
class ImplicitMultistepStepper : public MultistepHistory<method, P> {
 public:
  using Base = MultistepHistory<method, P>;
  using State = typename P::State;
  using Real = RealOf<State>;

  ImplicitMultistepStepper(const P& system, const State& model)
      : Base(system, model), past_(model), equation_(system, model) {}

  StepStatus attempt(Real t, const State& y, Real h, State& next, State& error) {
    this->look(t, y);
    if (this->starting()) return this->starter_.attempt(t, y, h, next, error);
    this->template combine_past<Formula>(y, h, past_);
    const bool solved =
        equation_.solve(t, y, t + h, past_, h * static_cast<Real>(method.formula.next_slope), next);
    return solved ? StepStatus::ok : StepStatus::newton_diverged;
  }
  NewtonCounts newton_counts() const {
    NewtonCounts sum = equation_.counts();
    if constexpr (requires { this->starter_.newton_counts(); })
      sum.lu += this->starter_.newton_counts().lu, sum.newton += this->starter_.newton_counts().newton;
    return sum;
  }

 private:
  struct Formula {
    static constexpr const auto& formula = method.formula;
  };
  State past_;
  ImplicitEquation<P> equation_;
};

/// The second evaluation of a step is the first look of the next: two evaluations per step.
template <const auto& method, System P>
class PredictorCorrectorStepper : public MultistepHistory<method, P> {
 public:
  using Base = MultistepHistory<method, P>;
  using State = typename P::State;
  using Real = RealOf<State>;

  PredictorCorrectorStepper(const P& system, const State& model)
      : Base(system, model), predicted_(model), slope_there_(model) {}

  StepStatus attempt(Real t, const State& y, Real h, State& next, State& error) {
    this->look(t, y);
    if (this->starting()) return this->starter_.attempt(t, y, h, next, error);
    this->template combine_past<Predictor>(y, h, predicted_);
    this->system_.rhs(t + h, predicted_, slope_there_);
    this->template combine_past<Corrector>(y, h, next);
    const Real weight = h * static_cast<Real>(method.corrector.next_slope);
    for_each_component(
        y, [&](std::size_t i) { next.data()[i] = next.data()[i] + weight * slope_there_.data()[i]; });
    return StepStatus::ok;
  }

 private:
  struct Predictor {
    static constexpr const auto& formula = method.predictor;
  };
  struct Corrector {
    static constexpr const auto& formula = method.corrector;
  };
  State predicted_, slope_there_;
};

}  // namespace odemark
