// Radau IIA with the order chosen as it goes: 5, 9 or 13.
#pragma once

#include "integrators/integrate.hpp"
#include "integrators/methods/radau_iia13.hpp"
#include "integrators/methods/radau_iia5.hpp"
#include "integrators/methods/radau_iia9.hpp"

namespace odemark {

template <const auto& method, System P>
class VariableOrderRadauStepper;

struct VariableOrderRadau {
  static constexpr std::string_view kind_name = "variable-order Radau IIA";
  static constexpr unsigned needs = 0;
  static constexpr bool solves_equations = true;
  static constexpr bool takes_fixed_steps = false;

  std::string_view id, source;
  int order;           // the lowest and where it starts
  int embedded_order;  // of the estimate there
  std::string_view advice = "";

  Theory theory() const {
    Theory theory;
    theory.blank_reason = "its order depends on the state, so no single function describes it";
    return theory;
  }

  template <const auto& method, System P>
  using Stepper = VariableOrderRadauStepper<method, P>;

  template <const auto& method, System P, class Observer>
  static RunReport drive(const P& system, const Control& control, double t0, double t1, typename P::State& y,
                         Observer&& observe) {
    if (const auto* adaptive = std::get_if<ErrorControl>(&control)) {
      VariableOrderRadauStepper<method, P> stepper(system, y);
      return integrate(stepper, system, *adaptive, method.embedded_order + 1, t0, t1, y, observe);
    }
    RunReport report;
    report.status = RunStatus::not_applicable;
    report.reason = "chooses its order by the tolerance: give one";
    report.t_reached = t0;
    return report;
  }
};

/// E. Hairer, G. Wanner, J. Comput. Appl. Math. 111 (1999) 93-111, section 4: a higher order pays once
/// Newton's iteration contracts well, because then the steps are small for the sake of accuracy alone; a
/// lower one once it barely contracts. Values between steps come from the highest order.
template <const auto& method, System P>
class VariableOrderRadauStepper {
 public:
  using State = typename P::State;
  using Real = RealOf<State>;

  VariableOrderRadauStepper(const P& system, const State& model)
      : low_(system, model), middle_(system, model), high_(system, model) {}

  void start() { high_.start(), active_ = 2; }
  void start(const ErrorControl& control) {
    control_ = &control;
    active_ = 0, steps_at_order_ = 0, failed_ = false;
    low_.start(control);
  }
  StepStatus attempt(Real t, const State& y, Real h, State& next, State& error) {
    return with_active([&](auto& s) { return s.attempt(t, y, h, next, error); });
  }
  void accept() {
    with_active([](auto& s) { s.accept(); });
    ++steps_at_order_;
  }
  Real own_factor(Real h, double norm) {
    const Real factor = with_active([&](auto& s) { return s.own_factor(h, norm); });
    const Real theta = with_active([](auto& s) { return s.newton().slowest_rate(); });
    failed_ = failed_ || !(norm < 1e300);
    if (!(norm <= 1)) return factor;
    if (active_ > 0 && (failed_ || !(theta < Real(0.8)))) {
      change_order(active_ - 1);
    } else if (active_ < 2 && steps_at_order_ >= 10 && theta > 0 && theta <= Real(0.002) &&
               factor > Real(0.8) && factor < Real(1.2)) {  // 0: one iteration tells no rate
      change_order(active_ + 1);
    }
    failed_ = false;
    return factor;
  }
  NewtonCounts newton_counts() const {
    NewtonCounts sum;
    for (const auto& c : {low_.newton_counts(), middle_.newton_counts(), high_.newton_counts()})
      sum.lu += c.lu, sum.newton += c.newton;
    return sum;
  }

 private:
  template <class F>
  auto with_active(const F& f) {
    return active_ == 0 ? f(low_) : active_ == 1 ? f(middle_) : f(high_);
  }
  void change_order(int wished) {
    active_ = wished;
    steps_at_order_ = 0;
    with_active([&](auto& s) { s.resume(*control_); });
  }

  StepperOf<radau_iia5, P> low_;
  StepperOf<radau_iia9, P> middle_;
  StepperOf<radau_iia13, P> high_;
  const ErrorControl* control_ = nullptr;
  int active_ = 0, steps_at_order_ = 0;
  bool failed_ = false;  // an attempt since the last accepted step
};

}  // namespace odemark
