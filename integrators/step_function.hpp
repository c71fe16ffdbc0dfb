// Any function that advances a state is a method: the door for an engine's own update code.
#pragma once

#include "integrators/theory.hpp"

namespace odemark {

template <class F, class P>
concept StepsAlone = requires(const F& f, const P& p, typename P::State& y, RealOf<typename P::State> t) {
  f(p, t, y, t);
};
template <class F, class P>
concept StepsWithScratch = requires(const F& f, const P& p, typename P::State& y,
                                    RealOf<typename P::State> t) {
  f(p, t, y, t, y);
};

template <const auto& method, System P>
class StepFunctionStepper {
 public:
  using State = typename P::State;
  using Real = RealOf<State>;

  StepFunctionStepper(const P& system, const State& model) : system_(system), scratch_(model) {}
  void start() {}
  void accept() {}
  StepStatus attempt(Real t, const State& y, Real h, State& next, State&) {
    next = y;
    if constexpr (StepsWithScratch<decltype(method.step), P>)
      method.step(system_, t, next, h, scratch_);
    else
      method.step(system_, t, next, h);
    return StepStatus::ok;
  }

 private:
  const P& system_;
  State scratch_;
};

template <class P, class F>
concept AcceptedBy = System<P> &&(StepsAlone<F, P> || StepsWithScratch<F, P>);

/// `step(problem, t, y, h)` overwrites y(t) with y(t + h); `step(problem, t, y, h, scratch)` may use a second
/// state as its own and so allocate nothing. Constrain its first parameter to say what it
/// needs; `Needs` says the same in Ability bits, for problems whose type is gone.
template <class F, unsigned Needs>
struct StepFunction {
  static constexpr std::string_view kind_name = "step function";
  static constexpr unsigned needs = Needs;
  std::string_view id, source;
  int order;
  int embedded_order;
  F step;
  std::vector<SecondOrderMove> (*moves)() = nullptr;
  std::string_view note = "", advice = "";

  Theory theory() const {
    Theory theory;
    if (moves)
      theory.moves = moves();
    else
      theory.blank_reason = "a step function has no coefficients to derive a limit from";
    return theory;
  }

  template <const auto& method, AcceptedBy<F> P>
  using Stepper = StepFunctionStepper<method, P>;
};

template <unsigned Needs = 0, class F>
constexpr StepFunction<F, Needs> wrap_step(std::string_view id, int order, F step,
                                           std::string_view source = "user code") {
  return {id, source, order, 0, step};
}

}  // namespace odemark
