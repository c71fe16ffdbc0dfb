// Semi-implicit Euler with the damping part of the force treated apart, as engines do: implicit, exact, or by
// a drag factor.
#pragma once

#include <cmath>

#include "integrators/matrix_exponential.hpp"
#include "integrators/theory.hpp"
#include "integrators/velocity_block_lu.hpp"

namespace odemark {

template <const auto& method, SecondOrderSystem P>
class DampedEulerStepper;

/// The matrix of a step that ends with x+ = x + h v+, where v+ = of_x x + of_v v; column-major.
inline std::vector<Coefficient> moved_by_new_velocity(Coefficient of_x, Coefficient of_v, Coefficient h) {
  return {1 + h * of_x, of_x, h * of_v, of_v};
}

/// With D = da/dv at the start of the step and r = a - D v, the force without its damping:
/// implicit:   v+ = v + h r + h D v+, one linear solve;
/// exact:      v+ = exp(h D) v + h r;
/// drag_rule:  v+_i = max(0, 1 - h d_i) (v_i + h (a_i + d_i v_i)), d_i = -D_ii: what couples stays in the
/// force; then x+ = x + h v+. For forces without velocity all three are semi-implicit Euler.
struct DampedEuler {
  enum class Damping { implicit, exact, drag_rule };
  static constexpr std::string_view kind_name = "semi-implicit Euler, damping apart";
  static constexpr unsigned needs = Ability::second_order | Ability::jacobian;

  std::string_view id, source;
  int order = 1;
  int embedded_order = 0;
  Damping damping;
  std::string_view note = "", advice = "";

  /// What this method needs beyond its kind: a matrix exponential is no banded matrix.
  constexpr unsigned more_needs() const {
    return damping == Damping::exact ? unsigned(Ability::moderate_size) : 0;
  }

  Theory theory() const {
    using What = SecondOrderMove::What;
    Theory theory;
    switch (damping) {
      case Damping::implicit: theory.moves = {{What::kick_implicit, 1}, {What::drift, 1}}; break;
      case Damping::exact:
        theory.second_order_step = [](Coefficient stiffness, Coefficient rate, Coefficient h) {
          return moved_by_new_velocity(-h * stiffness, std::exp(-h * rate), h);
        };
        break;
      case Damping::drag_rule:
        theory.second_order_step = [](Coefficient stiffness, Coefficient rate, Coefficient h) {
          const Coefficient left = h * rate < 1 ? 1 - h * rate : 0;
          return moved_by_new_velocity(-h * stiffness * left, left, h);
        };
        break;
    }
    return theory;
  }

  template <const auto& method, SecondOrderSystem P>
  using Stepper = DampedEulerStepper<method, P>;
};

template <const auto& method, SecondOrderSystem P>
class DampedEulerStepper {
 public:
  using State = typename P::State;
  using Real = RealOf<State>;

  DampedEulerStepper(const P& system, const State& model)
      : system_(system), half_(size_of(model) / 2), solver_(system, model), a_(half_), damped_(half_) {}

  void start() {}
  void accept() {}
  NewtonCounts newton_counts() const { return counts_; }

  StepStatus attempt(Real t, const State& y, Real h, State& next, State&) {
    system_.acceleration(t, y, a_.data());
    if (system_.force_depends_on_velocity())
      kick(t, y, h);
    else
      for (std::size_t i = 0; i < half_; ++i) damped_[i] = y.data()[half_ + i] + h * a_[i];
    for (std::size_t i = 0; i < half_; ++i) {
      next.data()[half_ + i] = damped_[i];
      next.data()[i] = y.data()[i] + h * damped_[i];
    }
    return StepStatus::ok;
  }

 private:
  using Damping = DampedEuler::Damping;

  /// v+ into damped_, from the force in a_.
  void kick(Real t, const State& y, Real h) {
    const Real* v = y.data() + half_;
    if constexpr (method.damping == Damping::implicit) {
      solver_.factorize(t, y, h);
      ++counts_.lu;
      solver_.solve_in_place(a_.data());
      for (std::size_t i = 0; i < half_; ++i) damped_[i] = v[i] + h * a_[i];
    } else if constexpr (method.damping == Damping::exact) {
      solver_.jacobian.evaluate(t, y);
      fill(solver_.exponential.matrix());
      solver_.exponential.prepare(h);
      solver_.exponential.multiply(v, damped_.data());
      for (std::size_t i = 0; i < half_; ++i) {
        Real rest = a_[i];
        for (std::size_t j = 0; j < half_; ++j) rest -= solver_.jacobian.by_velocity(i, j) * v[j];
        damped_[i] += h * rest;
      }
    } else {
      solver_.evaluate(t, y);
      for (std::size_t i = 0; i < half_; ++i) {
        const Real drag = -solver_.by_velocity(i, i), left = 1 - h * drag;
        damped_[i] = (left < 0 ? Real(0) : left) * (v[i] + h * (a_[i] + drag * v[i]));
      }
    }
  }
  void fill(Real* column_major) const {
    for (std::size_t c = 0; c < half_; ++c)
      for (std::size_t r = 0; r < half_; ++r)
        column_major[c * half_ + r] = solver_.jacobian.by_velocity(r, c);
  }

  struct Exact {
    SecondOrderJacobian<P> jacobian;
    MatrixExponential<Real> exponential;
    Exact(const P& system, const State& model) : jacobian(system, model), exponential(size_of(model) / 2) {}
  };
  using Solver =
      std::conditional_t<method.damping == Damping::implicit, VelocityBlockLu<P>,
                         std::conditional_t<method.damping == Damping::exact, Exact, SecondOrderJacobian<P>>>;

  const P& system_;
  std::size_t half_;
  Solver solver_;
  std::vector<Real> a_, damped_;
  NewtonCounts counts_;
};

}  // namespace odemark
