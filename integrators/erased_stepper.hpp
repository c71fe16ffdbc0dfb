// A stepper whose type is gone: the loops, samplers and measurements around it are compiled once per number
// type.
#pragma once

#include "integrators/any_method.hpp"

namespace odemark {

/// A view of a stepper on run-time-size states; the stepper must outlive it. One call through a pointer per
/// step, so it serves runs that are counted and looked at; what is timed runs inside its own loop. Every
/// number is that of the stepper behind it. What the stepper cannot do is asked at run time (`can`).
template <class T>
class ErasedStepper {
 public:
  using State = std::vector<T>;
  struct Can {
    bool compensated, controlled, choose_steps, second_error;
    bool history;
  };

  template <Stepper S>
  requires(!std::is_same_v<S, ErasedStepper>) explicit ErasedStepper(S& stepper)
      : self_(&stepper), calls_(&calls_of<S>) {}

  const Can& can() const { return calls_->can; }
  void start() { calls_->start(self_); }
  void start(const ErrorControl& control) { calls_->start_controlled(self_, control); }
  StepStatus attempt(T t, const State& y, T h, State& next, State& error) {
    return calls_->attempt(self_, t, y, h, next, error);
  }
  StepStatus attempt_compensated(T t, const State& y, const State& carry, T h, State& next,
                                 State& next_carry) {
    return calls_->attempt_compensated(self_, t, y, carry, h, next, next_carry);
  }
  void accept() { calls_->accept(self_); }
  NewtonCounts newton_counts() const { return calls_->newton_counts(self_); }
  const State& second_error() const { return *calls_->second_error(self_); }
  T own_factor(T h, double error) { return calls_->own_factor(self_, h, error); }
  T choose_factor(T wished, double error) { return calls_->choose_factor(self_, wished, error); }
  std::size_t history_length() const { return calls_->history_length(self_); }
  State& history(std::size_t k) { return *calls_->history(self_, k); }
  void assume_history() { calls_->assume_history(self_); }

 private:
  struct Calls {
    Can can;
    void (*start)(void*);
    void (*start_controlled)(void*, const ErrorControl&);
    StepStatus (*attempt)(void*, T, const State&, T, State&, State&);
    StepStatus (*attempt_compensated)(void*, T, const State&, const State&, T, State&, State&);
    void (*accept)(void*);
    NewtonCounts (*newton_counts)(void*);
    const State* (*second_error)(void*);
    T (*own_factor)(void*, T, double);
    T (*choose_factor)(void*, T, double);
    std::size_t (*history_length)(void*);
    State* (*history)(void*, std::size_t);
    void (*assume_history)(void*);
  };

  template <class S>
  static S& as(void* self) {
    return *static_cast<S*>(self);
  }
  template <class S>
  static constexpr Calls calls_of = {.can = {CompensatedStepper<S>, ControlledStepper<S>, ChoosesSteps<S>,
                                             requires(const S& s){s.second_error();
}, HasHistory<S>
}  // namespace odemark
, .start = [](void* s) { as<S>(s).start(); },
  .start_controlled =
      [](void* s, [[maybe_unused]] const ErrorControl& control) {
        if constexpr (ControlledStepper<S>)
          as<S>(s).start(control);
        else
          as<S>(s).start();
      },
  .attempt = [](void* s, T t, const State& y, T h, State& next,
                State& error) { return as<S>(s).attempt(t, y, h, next, error); },
  .attempt_compensated =
      [](void* s, T t, const State& y, const State& carry, T h, State& next, State& next_carry) {
        if constexpr (CompensatedStepper<S>)
          return as<S>(s).attempt_compensated(t, y, carry, h, next, next_carry);
        else
          return as<S>(s).attempt(t, y, h, next, next_carry);
      },
  .accept = [](void* s) { as<S>(s).accept(); },
  .newton_counts = [](void* s) { return newton_counts_of(as<S>(s)); },
  .second_error = [](void* s) -> const State* {
    if constexpr (requires { as<S>(s).second_error(); })
      return &as<S>(s).second_error();
    else
      return nullptr;
  },
  .own_factor =
      [](void* s, T h, double error) {
        if constexpr (ChoosesSteps<S>)
          return as<S>(s).own_factor(h, error);
        else
          return T(1);
      },
  .choose_factor =
      [](void* s, T wished, [[maybe_unused]] double error) {
        if constexpr (AdvisesOnSteps<S>)
          return as<S>(s).choose_factor(wished, error);
        else
          return wished;
      },
  .history_length = [](void* s) -> std::size_t {
    if constexpr (HasHistory<S>)
      return as<S>(s).history_length();
    else
      return 0;
  },
  .history = [](void* s, std::size_t k) -> State* {
    if constexpr (HasHistory<S>)
      return &as<S>(s).history(k);
    else
      return nullptr;
  },
  .assume_history = [](void* s) {
    if constexpr (HasHistory<S>) as<S>(s).assume_history();
  },
}
;

void* self_;
const Calls* calls_;
}
;

extern template double first_step(const ErasedSystem<float>&, const ErrorControl&, int, double, double,
                                  const std::vector<float>&);
extern template double first_step(const ErasedSystem<double>&, const ErrorControl&, int, double, double,
                                  const std::vector<double>&);
extern template double first_step(const ErasedSystem<long double>&, const ErrorControl&, int, double, double,
                                  const std::vector<long double>&);

/// What error control gets from a method without an estimate.
RunReport no_error_estimate(double t0);

/// What follows from a method's stepper alone, in loops that all methods share. error_order 0 says that there
/// is no estimate: error control is then not applicable.
template <class T>
void set_runs(MethodRuns<T>& runs, typename MethodRuns<T>::WithStepper* with_stepper, int error_order);

}  // namespace odemark
