// One step of a rotating body: a function of the body, the time, the step and what turns.
#pragma once

#include "integrators/rotation.hpp"
#include "integrators/theory.hpp"

namespace odemark {

template <const auto& method, RotatingSystem P>
class RotationStepper;

/// `step(body, t, h, turning)` overwrites (w, q) at t with (w, q) at t + h; it asks the body for torques and
/// moments. All of them treat the attitude as a rotation, so they need more than a right-hand side.
template <class F>
struct RotationStep {
  static constexpr std::string_view kind_name = "rotation";
  static constexpr unsigned needs = Ability::rotation;

  std::string_view id, source;
  int order;
  int embedded_order = 0;
  F step{};
  int order_with_rate_torque = 0;  // where a torque depends on the rate; 0: the order stands
  std::string_view note = "", advice = "";

  Theory theory() const {
    Theory theory;
    theory.blank_reason = "turns a rigid body: there is no linear test equation of that";
    return theory;
  }

  template <const auto& method, RotatingSystem P>
  using Stepper = RotationStepper<method, P>;
};

template <const auto& method, RotatingSystem P>
class RotationStepper {
 public:
  using State = typename P::State;
  using Real = RealOf<State>;

  RotationStepper(const P& system, const State& model) : body_(system, model) {}
  void start() {}
  void accept() {}
  StepStatus attempt(Real t, const State& y, Real h, State& next, State&) {
    Turning<Real> turning = body_.read(y);
    method.step(body_, t, h, turning);
    body_.write(turning, next);
    return StepStatus::ok;
  }

 private:
  RigidBody<P> body_;
};

}  // namespace odemark
