// The engine's rk4 on the oscillator with a superfluous pass over the state: what the gate must find.
#pragma once

#include <functional>

#include "bench/family_system.hpp"
#include "bench/step_cost/keep.hpp"
#include "integrators/integrate.hpp"
#include "integrators/methods/rk4.hpp"
#include "problems/oscillator.hpp"

namespace odemark {

template <class P>
class PassingStepper : public StepperOf<rk4, P> {
 public:
  using State = typename P::State;
  using Real = RealOf<State>;
  using StepperOf<rk4, P>::StepperOf;

  StepStatus attempt(Real t, const State& y, Real h, State& next, State& error) {
    const StepStatus status = StepperOf<rk4, P>::attempt(t, y, h, next, error);
    State copy = next;  // through memory, as an innocent temporary of an engine would go
    keep(copy);
    next = copy;
    return status;
  }
};

inline std::function<double(long)> planted_loop() {
  return [](long count) {
    using P = FamilySystem<Oscillator<double>, double>;
    P system{};
    keep(system);
    P::State y;
    system.family.initial(y.data());
    PassingStepper<P> stepper(system, y);
    integrate(stepper, FixedSteps{count}, 0, static_cast<double>(count) / 64, y);
    return y[0] + y[1];
  };
}

}  // namespace odemark
