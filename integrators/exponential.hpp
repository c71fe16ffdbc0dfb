// Exponential Euler: the linear part exactly, the rest frozen over the step.
#pragma once

#include "integrators/compensated.hpp"
#include "integrators/phi_functions.hpp"
#include "integrators/theory.hpp"

namespace odemark {

template <const auto& method, HasLinearPart P>
class ExponentialEulerStepper;

/// y+ = y + h phi_1(h L) f(t, y), phi_1(z) = (e^z - 1) / z: exact where f(t, y) = L y + constant (M.
/// Hochbruck, A. Ostermann, Acta Numerica 19 (2010) 209-286, eq. 2.5, in the form that needs f only).
struct ExponentialEuler {
  static constexpr std::string_view kind_name = "exponential";
  static constexpr unsigned needs = Ability::linear_part;

  std::string_view id, source;
  int order;
  int embedded_order = 0;

  Theory theory() const {
    Theory theory;
    theory.exact_on_linear_part = true;
    return theory;
  }

  template <const auto& method, HasLinearPart P>
  using Stepper = ExponentialEulerStepper<method, P>;
};

template <const auto& method, HasLinearPart P>
class ExponentialEulerStepper {
 public:
  using State = typename P::State;
  using Real = RealOf<State>;

  ExponentialEulerStepper(const P& system, const State& model)
      : system_(system), phi_(size_of(model)), slope_(model), increment_(model) {
    system.linear_part(MatrixView<Real>{phi_.linear_part(), size_of(model)});
  }

  void start() {}
  void accept() {}

  StepStatus attempt(Real t, const State& y, Real h, State& next, State&) {
    take_increment(t, y, h);
    for_each_component(y, [&](std::size_t i) { next.data()[i] = y.data()[i] + increment_.data()[i]; });
    return StepStatus::ok;
  }
  StepStatus attempt_compensated(Real t, const State& y, const State& carry, Real h, State& next,
                                 State& next_carry) {
    take_increment(t, y, h);
    add_compensated(y, carry, increment_, next, next_carry);
    return StepStatus::ok;
  }

 private:
  void take_increment(Real t, const State& y, Real h) {
    if (!(h == prepared_)) phi_.prepare(prepared_ = h);  // once per run of equal steps
    system_.rhs(t, y, slope_);
    phi_.multiply(slope_.data(), increment_.data());
  }

  const P& system_;
  PhiMatrix<Real> phi_;
  State slope_, increment_;
  Real prepared_ = std::numeric_limits<Real>::quiet_NaN();
};

}  // namespace odemark
