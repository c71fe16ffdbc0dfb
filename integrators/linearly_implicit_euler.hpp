// Implicit Euler on x'' = a(t, x, v) with one linear solve instead of an iteration.
#pragma once

#include "integrators/second_order_jacobian.hpp"
#include "integrators/shifted_lu.hpp"
#include "integrators/theory.hpp"

namespace odemark {

template <const auto& method, SecondOrderSystem P>
class LinearlyImplicitEulerStepper;

/// With A = da/dx and D = da/dv, a and both blocks taken at t + h and at (X, v):
/// start:      X = x,       (I - h D - h^2 A) (v+ - v) = h (a + h A v);
/// prediction: X = x + h v, (I - h D - h^2 A) (v+ - v) = h a;
/// then x+ = x + h v+. On linear forces both are implicit Euler; elsewhere they differ in where they look.
struct LinearlyImplicitEuler {
  enum class Where { start, prediction };
  static constexpr std::string_view kind_name = "linearly implicit Euler";
  static constexpr unsigned needs = Ability::second_order | Ability::jacobian;

  std::string_view id, source;
  int order = 1;
  int embedded_order = 0;
  Where linearised_at;
  std::string_view note = "", advice = "";

  Theory theory() const {
    Theory theory;
    theory.second_order_step = [](Coefficient stiffness, Coefficient damping, Coefficient h) {
      const Coefficient below = 1 + h * damping + h * h * stiffness;
      return std::vector<Coefficient>{(1 + h * damping) / below, -h * stiffness / below, h / below,
                                      1 / below};
    };
    return theory;
  }

  template <const auto& method, SecondOrderSystem P>
  using Stepper = LinearlyImplicitEulerStepper<method, P>;
};

template <const auto& method, SecondOrderSystem P>
class LinearlyImplicitEulerStepper {
 public:
  using State = typename P::State;
  using Real = RealOf<State>;

  LinearlyImplicitEulerStepper(const P& system, const State& model)
      : system_(system),
        half_(size_of(model) / 2),
        jacobian_(system, model),
        matrix_(jacobian_.block_shape()),
        lu_(matrix_.shape()),
        look_(model),
        change_(half_) {}

  void start() {}
  void accept() {}
  NewtonCounts newton_counts() const { return counts_; }

  StepStatus attempt(Real t, const State& y, Real h, State& next, State&) {
    constexpr bool predicts = method.linearised_at == LinearlyImplicitEuler::Where::prediction;
    const Real* v = y.data() + half_;
    look_ = y;
    if constexpr (predicts)
      for (std::size_t i = 0; i < half_; ++i) look_.data()[i] += h * v[i];
    system_.acceleration(t + h, look_, change_.data());
    jacobian_.evaluate(t + h, look_);
    if constexpr (!predicts)
      for (std::size_t i = 0; i < half_; ++i)
        jacobian_.for_each_near(i,
                                [&](std::size_t j) { change_[i] += h * jacobian_.by_position(i, j) * v[j]; });
    const auto block = matrix_.view();
    for (std::size_t r = 0; r < half_; ++r)
      jacobian_.for_each_near(r, [&](std::size_t c) {
        block(r, c) = jacobian_.by_velocity(r, c) + h * jacobian_.by_position(r, c);
      });
    lu_.factorize_step(matrix_, h);
    ++counts_.lu;
    lu_.solve_in_place(change_.data());
    for (std::size_t i = 0; i < half_; ++i) {
      next.data()[half_ + i] = v[i] + h * change_[i];
      next.data()[i] = y.data()[i] + h * next.data()[half_ + i];
    }
    return StepStatus::ok;
  }

 private:
  const P& system_;
  std::size_t half_;
  SecondOrderJacobian<P> jacobian_;
  JacobianMatrix<Real> matrix_;
  ShiftedLu<Real> lu_;
  State look_;
  std::vector<Real> change_;  // (v+ - v) / h
  NewtonCounts counts_;
};

}  // namespace odemark
