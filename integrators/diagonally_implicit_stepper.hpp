// The step of a diagonally implicit Runge-Kutta method: stage by stage, simplified Newton on one
// factorization.
#pragma once

#include <limits>

#include "integrators/compensated.hpp"
#include "integrators/diagonally_implicit_table.hpp"
#include "integrators/jacobian.hpp"
#include "integrators/newton_control.hpp"
#include "integrators/shifted_lu.hpp"

namespace odemark {

/// The unknown of stage i is z = h a_ii f(base + z). Started plainly every stage is solved to round-off with
/// the Jacobian where the first implicit stage is expected; started with an error control the iteration stops
/// by the tolerance, and Jacobian and factors are kept while they serve.
template <const auto& method, System P>
class DiagonallyImplicitRungeKuttaStepper {
 public:
  using State = typename P::State;
  using Real = RealOf<State>;

  DiagonallyImplicitRungeKuttaStepper(const P& system, const State& model)
      : system_(system),
        size_(size_of(model)),
        jacobian_(jacobian_shape(system, model)),
        lu_(jacobian_.shape()),
        last_lu_(jacobian_.shape()) {
    for (State* s : {&stage_, &base_, &spare_, &correction_, &z_, &weight_, &last_slope_, &last_point_})
      *s = zeros_like(model);
    slopes_.fill(stage_);
  }

  void start() {
    control_ = nullptr;
    forget();
  }
  void start(const ErrorControl& control) {
    control_ = &control;
    newton_.start(control, {.power = 1, .kappa = newton_share<method>(), .most = 7, .fast = 0.02});
    forget();
  }
  void accept() {
    std::swap(last_slope_, slopes_[S - 1]);
    last_slope_known_ = true;
    last_shift_ = 0;
    if (!control_ && foreseeable_ && method.a[S - 1][S - 1] != 0) {
      std::swap(last_point_, stage_);
      std::swap(last_lu_, lu_);
      std::swap(last_shift_, factored_);
    }
    jacobian_is_current_ = false;
    keep_jacobian_ = control_ && newton_.converges_fast();
    attempts_ = 0;
  }
  Real choose_factor(Real wished, double norm) { return Real(newton_.choose_factor(double(wished), norm)); }
  NewtonCounts newton_counts() const { return counts_; }

  StepStatus attempt(Real t, const State& y, Real h, State& next, State& error) {
    if (!solve_stages(t, y, h)) return StepStatus::newton_diverged;
    if constexpr (method.stiffly_accurate() && method.a[S - 1][S - 1] != 0)
      next = stage_;
    else
      add_slopes(y, h, table.b, next);
    if constexpr (method.embedded_order > 0) {
      clear(error);
      add_slopes(error, h, table.error, error);
      if constexpr (method.filter_estimate) {
        for_each_component(error, [&](std::size_t n) { error.data()[n] *= factored_; });
        lu_.solve_in_place(error.data());
      }
    }
    return StepStatus::ok;
  }
  StepStatus attempt_compensated(Real t, const State& y, const State& carry, Real h, State& next,
                                 State& next_carry) {
    compensated_ = true;
    const bool solved = solve_stages(t, y, h);
    compensated_ = false;
    if (!solved) return StepStatus::newton_diverged;
    clear(correction_);
    add_slopes(correction_, h, table.b, correction_);
    add_compensated(y, carry, correction_, next, next_carry);
    return StepStatus::ok;
  }

 private:
  static constexpr std::size_t S = method.stages, N = inlined_size<State>;
  static constexpr std::size_t first_implicit = [] {
    std::size_t i = 0;
    while (method.a[i][i] == 0) ++i;
    return i;
  }();

  static constexpr DirkTable<method, Real> table{};

  static void clear(State& s) {
    for_each_component(s, [&](std::size_t n) { s.data()[n] = Real(0); });
  }
  /// out = base + h (w_0 k_0 + ... ), the first `count` slopes.
  void add_slopes(const State& base, Real h, const std::array<Real, S>& weights, State& out,
                  std::size_t count = S) const {
    for_each_component(base, [&](std::size_t n) {
      Real sum = base.data()[n];
      for (std::size_t j = 0; j < count; ++j) sum += h * weights[j] * slopes_[j].data()[n];
      out.data()[n] = sum;
    });
  }

  void forget() {
    keep_jacobian_ = jacobian_is_current_ = last_slope_known_ = false;
    factored_ = last_shift_ = 0;
    attempts_ = 0;
  }
  void refresh_jacobian(Real t, const State& y) {
    evaluate_jacobian(system_, t, y, jacobian_, spare_, correction_, weight_);
    if (control_) set_weights(y);  // which served as scratch
    factored_ = 0;
  }
  void set_weights(const State& y) {
    for_each_component(y, [&](std::size_t n) {
      weight_.data()[n] = Real(newton_.inverse_weight(n, double(std::abs(y.data()[n]))));
    });
  }
  void factorize(Real shift) {
    if (factored_ == shift) return;
    lu_.factorize(jacobian_, factored_ = shift);
    ++counts_.lu;
  }

  bool solve_stages(Real t, const State& y, Real h) {
    if (!control_) {
      foreseeable_ = true;
      return run_stages(t, y, h);
    }
    set_weights(y), newton_.begin_step();
    if (!jacobian_is_current_ && (!keep_jacobian_ || attempts_ > 0)) {
      refresh_jacobian(t, y);
      jacobian_is_current_ = true;
    }
    ++attempts_;
    if (run_stages(t, y, h)) return true;
    if (jacobian_is_current_) return false;
    refresh_jacobian(t, y);
    jacobian_is_current_ = true;
    newton_.begin_step();
    return run_stages(t, y, h);
  }

  bool run_stages(Real t, const State& y, Real h) {
    for (std::size_t i = 0; i < S; ++i) {
      const Real stage_time = t + table.c[i] * h;
      add_slopes(y, h, table.a[i], base_, i);
      if (table.a[i][i] == 0) {
        // the last stage of a stiffly accurate step has it already, without the noise of f
        if (i == 0 && method.stiffly_accurate() && last_slope_known_)
          slopes_[0] = last_slope_;
        else
          system_.rhs(stage_time, base_, slopes_[i]);
        continue;
      }
      const Real shift = 1 / (h * table.a[i][i]);
      if (control_) {
        guess_stage(i, shift);
        factorize(shift);
        if (!iterate_to_tolerance(stage_time, shift)) return false;
      } else if (!solve_stage(i, t, y, stage_time, shift)) {
        return false;
      }
      for_each_component(z_, [&](std::size_t n) {
        stage_.data()[n] = base_.data()[n] + z_.data()[n];
        slopes_[i].data()[n] = shift * z_.data()[n];
      });
    }
    return true;
  }

  void guess_stage(std::size_t i, Real shift) {
    clear(z_);
    if (i > 0) {
      add_slopes(z_, 1 / shift, table.guess[i], z_, i);
    } else if (last_slope_known_) {
      for_each_component(z_, [&](std::size_t n) { z_.data()[n] = last_slope_.data()[n] / shift; });
    }
  }
  /// What an iteration would make of the last stage of the last step, for whose factors nothing is evaluated.
  void foresee_stage(Real shift) {
    for_each_component(z_, [&](std::size_t n) {
      z_.data()[n] = last_point_.data()[n] - base_.data()[n];
      correction_.data()[n] = last_slope_.data()[n] - shift * z_.data()[n];
    });
    last_lu_.solve_in_place(correction_.data());
    for_each_component(z_, [&](std::size_t n) { z_.data()[n] += correction_.data()[n]; });
  }
  void start_from(const State& y) {
    for_each_component(z_, [&](std::size_t n) { z_.data()[n] = y.data()[n] - base_.data()[n]; });
  }
  void find_stage() {
    for_each_component(z_, [&](std::size_t n) { stage_.data()[n] = base_.data()[n] + z_.data()[n]; });
  }

  /// correction = (shift I - J)^-1 (f(base + z) - shift z), the slope left in `spare`.
  void correct(Real stage_time, Real shift) {
    find_stage();
    system_.rhs(stage_time, stage_, spare_);
    for_each_component(
        z_, [&](std::size_t n) { correction_.data()[n] = spare_.data()[n] - shift * z_.data()[n]; });
    lu_.solve_in_place(correction_.data());
    ++counts_.newton;
  }

  bool iterate_to_tolerance(Real stage_time, Real shift) {
    newton_.begin();
    for (;;) {
      correct(stage_time, shift);
      Real sum = 0;
      for_each_component(z_, [&](std::size_t n) {
        z_.data()[n] += correction_.data()[n];
        const Real ratio = correction_.data()[n] * weight_.data()[n];
        sum += ratio * ratio;
      });
      const auto verdict = newton_.judge(std::sqrt(sum / Real(size_)));
      if (verdict != NewtonVerdict::go_on) return verdict == NewtonVerdict::converged;
    }
  }
  /// To round-off. Where the last step's iteration was quick its factors foresee the first stage; where it
  /// was not, or what they foresee leads nowhere, the way starts at y, far from which a stage may have two
  /// solutions.
  bool solve_stage(std::size_t i, Real t, const State& y, Real stage_time, Real shift) {
    if (i == first_implicit) {
      if (last_shift_ == shift) {
        foresee_stage(shift);
        find_stage();
        refresh_jacobian(stage_time, stage_);
        factorize(shift);
        if (iterate_to_round_off(stage_time, shift, false)) return true;
        foreseeable_ = false;
      }
      refresh_jacobian(t, y);
      start_from(y);
    } else {
      guess_stage(i, shift);
    }
    factorize(shift);
    if (iterate_to_round_off(stage_time, shift, false)) return true;
    start_from(y);
    return iterate_to_round_off(stage_time, shift, true);
  }

  /// `every` refreshes the Jacobian in every iteration, else that begins where it is slow.
  bool iterate_to_round_off(Real stage_time, Real shift, bool every) {
    RoundOffStop<Real> stop(every ? 48 : 20);
    for (;;) {
      if (every) {
        find_stage();
        refresh_jacobian(stage_time, stage_);
        factorize(shift);
      }
      correct(stage_time, shift);
      Real moved = 0, size = 0, terms = 0;
      for_each_component(z_, [&](std::size_t n) {
        z_.data()[n] += correction_.data()[n];
        moved += std::abs(correction_.data()[n]);
        size += std::abs(compensated_ ? z_.data()[n] : base_.data()[n] + z_.data()[n]);
        terms += std::abs(base_.data()[n]) + std::abs(spare_.data()[n] / shift);
      });
      const auto verdict = stop.judge(moved, size, terms);
      if (verdict != NewtonVerdict::go_on) return verdict == NewtonVerdict::converged;
      if (stop.is_slow()) foreseeable_ = false, every = true;
    }
  }

  const P& system_;
  std::size_t size_;
  JacobianMatrix<Real, N> jacobian_;
  ShiftedLu<Real, Real, N> lu_, last_lu_;
  std::array<State, S> slopes_;
  State stage_, base_, spare_, correction_, z_, weight_, last_slope_, last_point_;
  const ErrorControl* control_ = nullptr;
  NewtonControl<Real> newton_;
  NewtonCounts counts_;
  Real factored_ = 0, last_shift_ = 0;  // the shifts of the factors, 0 where there are none
  int attempts_ = 0;                    // since the last accepted step
  bool keep_jacobian_ = false, jacobian_is_current_ = false, last_slope_known_ = false, compensated_ = false,
       foreseeable_ = false;
};

}  // namespace odemark
