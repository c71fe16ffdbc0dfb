// Rosenbrock methods: linearly implicit Runge-Kutta, one factorization a step and no iteration.
#pragma once

#include "integrators/jacobian.hpp"
#include "integrators/rosenbrock_form.hpp"
#include "integrators/shifted_lu.hpp"
#include "integrators/theory.hpp"
#include "integrators/time_derivative.hpp"

namespace odemark {

template <const auto& method, System P>
class RosenbrockStepper;

/// k_i = h f(t + alpha_i h, y + sum_(j<i) alpha_ij k_j) + h J sum_(j<=i) gamma_ij k_j + gamma_i h^2 f_t, with
/// J and f_t at the start of the step; `gamma` carries one and the same number on its diagonal.
template <std::size_t Stages>
struct Rosenbrock {
  static constexpr std::string_view kind_name = "Rosenbrock";
  static constexpr unsigned needs = 0;
  static constexpr bool solves_equations = true;
  static constexpr std::size_t stages = Stages;

  std::string_view id, source, advice;
  std::string_view note = "";
  int order;
  int embedded_order = 0;
  bool propagates_lower = false;  // embedded_order is order + 1
  bool jumps_over_poles = false;  // see AnyMethod
  bool w_method = false;          // keeps its order whatever matrix stands for the Jacobian
  std::array<std::array<Coefficient, Stages>, Stages> alpha{}, gamma{};
  std::array<Coefficient, Stages> b{}, b_embedded{};

  constexpr RosenbrockForm<Stages> form() const { return {alpha, gamma, b, b_embedded}; }

  Theory theory() const {
    auto beta = alpha;
    for (std::size_t i = 0; i < Stages; ++i)
      for (std::size_t j = 0; j <= i; ++j) beta[i][j] += gamma[i][j];
    Theory theory = runge_kutta_theory(beta, b, embedded_order > 0 ? &b_embedded : nullptr);
    Coefficient size = 0;
    for (std::size_t i = 0; i < Stages; ++i)
      for (std::size_t j = 0; j < Stages; ++j)
        size += std::abs(b[i] * alpha[i][j]) + std::abs(b[i] * gamma[i][j]);
    theory.rounding_amplification = std::max<Coefficient>(1, size);
    theory.tableau.a.clear();
    for (const auto& row : alpha) theory.tableau.a.insert(theory.tableau.a.end(), row.begin(), row.end());
    for (const auto& row : gamma)
      theory.tableau.gamma.insert(theory.tableau.gamma.end(), row.begin(), row.end());
    return theory;
  }

  template <const auto& method, System P>
  using Stepper = RosenbrockStepper<method, P>;
};

/// A step on which det(I - h g J) has changed its sign lies beyond a pole of R: a growing mode would come
/// back from the other side of infinity, and a solution that ends would be stepped over. It fails, as an
/// implicit stage would. f, J and f_t at the start of a step outlive a rejected attempt: another h costs
/// stages and a factorization.
template <const auto& method, System P>
class RosenbrockStepper {
 public:
  using State = typename P::State;
  using Real = RealOf<State>;

  RosenbrockStepper(const P& system, const State& model)
      : system_(system),
        autonomous_(is_autonomous(system)),
        jacobian_(jacobian_shape(system, model)),
        lu_(jacobian_.shape()),
        first_(blank_like(model)),
        slope_(blank_like(model)),
        stage_(blank_like(model)),
        moved_(blank_like(model)),
        time_derivative_(blank_like(model)) {
    u_.fill(blank_like(model));
  }

  void start() { linearized_ = first_known_ = false; }
  void accept() {
    linearized_ = false;
    first_known_ = form.first_same_as_last();
    if (form.first_same_as_last()) std::swap(first_, slope_);
  }
  NewtonCounts newton_counts() const { return {factorizations_, 0}; }

  [[gnu::always_inline]] StepStatus attempt(Real t, const State& y, Real h, State& next, State& error) {
    if constexpr (fixed_size < State >> 0)
      return take_step(t, y, h, next, error);
    else
      return take_step_out_of_line(t, y, h, next, error);
  }

 private:
  /// Where the size is not known there is nothing to gain from a copy of the step in every loop.
  [[gnu::noinline]] StepStatus take_step_out_of_line(Real t, const State& y, Real h, State& next,
                                                     State& error) {
    return take_step(t, y, h, next, error);
  }
  [[gnu::always_inline]] StepStatus take_step(Real t, const State& y, Real h, State& next, State& error) {
    if (!linearized_) linearize(t, y, h);
    lu_.factorize_step(jacobian_, h * static_cast<Real>(form.diagonal));
    ++factorizations_;
    if (!lu_.has_positive_determinant()) return StepStatus::newton_diverged;
    [&]<std::size_t... I>(std::index_sequence<I...>) __attribute__((always_inline)) {
      (evaluate_stage<I>(t, y, h), ...);
    }
    (std::make_index_sequence<method.stages>{});
    if constexpr (form.first_same_as_last()) {
      next = stage_;
    } else if constexpr (form.ends_extended()) {
      for_each_component(
          y, [&](std::size_t n) { next.data()[n] = stage_.data()[n] + u_[method.stages - 1].data()[n]; });
    } else {
      for_each_component(y, [&](std::size_t n) { next.data()[n] = y.data()[n] + sum<Weights>(n); });
    }
    if constexpr (method.embedded_order > 0)
      for_each_component(y, [&](std::size_t n) { error.data()[n] = sum<ErrorWeights>(n); });
    return StepStatus::ok;
  }

  static constexpr auto form = method.form();

  template <std::size_t I>
  struct Argument {
    static constexpr Coefficient value(std::size_t j) { return form.argument[I][j]; }
  };
  template <std::size_t I>
  struct Coupling {
    static constexpr Coefficient value(std::size_t j) { return form.coupling[I][j]; }
  };
  struct Weights {
    static constexpr Coefficient value(std::size_t j) { return form.weight[j]; }
  };
  struct ErrorWeights {
    static constexpr Coefficient value(std::size_t j) { return form.error[j]; }
  };

  /// sum_j w_j u_j for component n, over the weights that are not zero.
  template <class W, std::size_t Count = method.stages>
  [[gnu::always_inline]] Real sum(std::size_t n) const {
    constexpr auto used = nonzero_weights<W, Count>();
    if constexpr (used.empty())
      return Real(0);
    else
      return [&]<std::size_t... U>(std::index_sequence<U...>) {
        return (... + (static_cast<Real>(W::value(used[U])) * u_[used[U]].data()[n]));
      }
    (std::make_index_sequence<used.size()>{});
  }

  [[gnu::always_inline]] void linearize(Real t, const State& y, Real h) {
    if (!first_known_) system_.rhs(t, y, first_);
    evaluate_jacobian(system_, t, y, jacobian_, slope_, stage_, moved_);
    if constexpr (form.needs_time_derivative())
      if (!autonomous_) evaluate_time_derivative(system_, t, h, y, first_, time_derivative_);
    first_known_ = linearized_ = true;
  }

  template <std::size_t I>
  [[gnu::always_inline]] void evaluate_stage(Real t, const State& y, Real h) {
    constexpr bool at_start = I == 0 || nonzero_weights<Argument<I>, I>().empty();
    if constexpr (at_start) {
      if constexpr (form.node[I] == 0)
        slope_ = first_;
      else
        system_.rhs(t + static_cast<Real>(form.node[I]) * h, y, slope_);
    } else if constexpr (!form.repeats(I)) {
      if constexpr (form.extends(I) && I > 1 && !nonzero_weights<Argument<I - 1>, I - 1>().empty())
        for_each_component(y, [&](std::size_t n) { stage_.data()[n] += u_[I - 1].data()[n]; });
      else
        for_each_component(y,
                           [&](std::size_t n) { stage_.data()[n] = y.data()[n] + sum<Argument<I>, I>(n); });
      system_.rhs(t + static_cast<Real>(form.node[I]) * h, stage_, slope_);
    }
    const Real slope_weight = h * static_cast<Real>(form.diagonal);
    for_each_component(y, [&](std::size_t n) {
      u_[I].data()[n] = sum<Coupling<I>, I>(n) + slope_weight * slope_.data()[n];
    });
    if constexpr (form.time[I] != 0)
      if (!autonomous_) {
        const Real time_weight = h * h * static_cast<Real>(form.time[I]);
        for_each_component(
            y, [&](std::size_t n) { u_[I].data()[n] += time_weight * time_derivative_.data()[n]; });
      }
    lu_.solve_in_place(u_[I].data());
  }

  const P& system_;
  bool autonomous_;
  JacobianMatrix<Real, inlined_size<State>> jacobian_;
  ShiftedLu<Real, Real, inlined_size<State>> lu_;
  std::array<State, method.stages> u_{};
  State first_, slope_, stage_, moved_, time_derivative_;
  bool linearized_ = false, first_known_ = false;
  long factorizations_ = 0;
};

}  // namespace odemark
