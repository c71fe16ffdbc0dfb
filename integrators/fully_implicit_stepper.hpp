// The step of a fully implicit Runge-Kutta method: simplified Newton on decoupled stages.
#pragma once

#include <limits>

#include "integrators/compensated.hpp"
#include "integrators/fully_implicit_runge_kutta.hpp"
#include "integrators/jacobian.hpp"
#include "integrators/newton_control.hpp"
#include "integrators/shifted_lu.hpp"
#include "integrators/stage_algebra.hpp"

namespace odemark {

/// E. Hairer, G. Wanner, Solving ODEs II, IV.8: unknowns are z_i = Y_i - y, decoupled by the eigenvectors of
/// A into one real and half as many complex systems. Started plainly it iterates to round-off; started with
/// an error control it stops where the error of the iteration is small beside the tolerance, keeps Jacobian
/// and factors while they serve, and advises on the step.
template <const auto& method, System P>
class FullyImplicitRungeKuttaStepper {
 public:
  using State = typename P::State;
  using Real = RealOf<State>;

  FullyImplicitRungeKuttaStepper(const P& system, const State& model)
      : system_(system),
        size_(size_of(model)),
        tables_(StageTables<Real, S>::template of<method>()),
        jacobian_(jacobian_shape(system, model)),
        real_lu_(make_all<real_modes, ShiftedLu<Real, Real, N>>()),
        pair_lu_(make_all<pairs, ShiftedLu<Real, PlainComplex<Real>, N>>()) {
    for (State* s : {&stage_, &weight_, &start_slope_, &increment_, &last_increment_, &spare_, &more_})
      *s = zeros_like(model);
    for (auto* all : {&z_, &w_, &f_, &r_, &last_z_}) all->fill(stage_);
    if constexpr (N == 0) complex_.resize(size_);
  }

  void start() {
    control_ = nullptr;
    forget();
  }
  void start(const ErrorControl& control) {
    control_ = &control;
    constexpr int most = 7 + 5 * (S > 3 ? int(S) - 3 : 0) / 2;
    constexpr double power = double(method.embedded_order + 1) / (method.order + 1);
    newton_.start(control, {.power = power, .kappa = 0, .most = most, .fast = 0.001});
    forget();
  }
  /// Start in the middle of a run of another method of the family.
  void resume(const ErrorControl& control) {
    start(control);
    newton_.resume();
    first_ = false;
  }
  NewtonCounts newton_counts() const { return counts_; }

  StepStatus attempt(Real t, const State& y, Real h, State& next, State& error) {
    if (!solve_stages(t, y, h)) return StepStatus::newton_diverged;
    for_each_component(y, [&](std::size_t n) { next.data()[n] = y.data()[n] + increment_.data()[n]; });
    if constexpr (method.embedded_order > 0) estimate(t, y, h, error);
    return StepStatus::ok;
  }
  StepStatus attempt_compensated(Real t, const State& y, const State& carry, Real h, State& next,
                                 State& next_carry) {
    if (!solve_stages(t, y, h)) return StepStatus::newton_diverged;
    add_compensated(y, carry, increment_, next, next_carry);
    return StepStatus::ok;
  }
  void accept() {
    std::swap(last_z_, z_), std::swap(last_increment_, increment_);
    last_h_ = attempted_h_;
    start_slope_known_ = false;
    jacobian_is_current_ = false;
    first_ = false;
    rejections_ = 0;
    keep_jacobian_ = control_ && newton_.converges_fast();
  }

  /// The factor on h after an attempt with this error, NaN where it failed.
  Real own_factor(Real h, double norm) {
    return Real(newton_.predict_factor(double(h), norm, method.embedded_order + 1));
  }

  const NewtonControl<Real>& newton() const { return newton_; }

 private:
  static constexpr std::size_t S = method.stages, N = inlined_size<State>, real_modes = method.real_modes,
                               pairs = (S - real_modes) / 2;
  static constexpr bool is_singular = method.is_singular(), starts_at_node = method.c(0) == 0;
  using Stages = std::array<State, S>;

  template <std::size_t Count, class Lu>
  std::array<Lu, Count> make_all() const {
    return [&]<std::size_t... I>(std::index_sequence<I...>) {
      return std::array<Lu, Count>{((void)I, Lu(jacobian_.shape()))...};
    }
    (std::make_index_sequence<Count>{});
  }

  void forget() {
    last_h_ = 0, factored_h_ = 0, rejections_ = 0;
    first_ = true;
    keep_jacobian_ = jacobian_is_current_ = start_slope_known_ = false;
  }

  bool solve_stages(Real t, const State& y, Real h) {
    attempted_h_ = h;
    if (control_) set_weights(y);
    if (!jacobian_is_current_ && (!keep_jacobian_ || rejections_ > 0)) refresh_jacobian(t, y);
    ++rejections_;  // until accept() says otherwise
    factorize(h);
    predict(h);
    if (!control_) {
      if (!iterate_to_round_off(t, y, h, false)) {
        // the Jacobian of the start may be far from that of the stages: once more, with Newton proper
        clear_stages(z_);
        jacobian_is_current_ = false;
        if (!iterate_to_round_off(t, y, h, true)) return false;
      }
    } else if (!iterate_to_tolerance(t, y, h)) {
      if (jacobian_is_current_) return false;
      refresh_jacobian(t, y);
      factorize(h);
      predict(h);
      if (!iterate_to_tolerance(t, y, h)) return false;
    }
    find_increment(t, y, h);
    return true;
  }

  void set_weights(const State& y) {
    for_each_component(y, [&](std::size_t n) {
      weight_.data()[n] = Real(newton_.inverse_weight(n, double(std::abs(y.data()[n]))));
    });
  }

  void refresh_jacobian(Real t, const State& y) {
    evaluate_jacobian(system_, t, y, jacobian_, spare_, more_, stage_);
    jacobian_is_current_ = true;
    factored_h_ = 0;
  }
  void factorize(Real h) {
    if (factored_h_ == h) return;
    factored_h_ = h;
    ++counts_.lu;
    for (std::size_t m = 0; m < real_modes; ++m)
      if (tables_.shift_re[m] != 0) real_lu_[m].factorize(jacobian_, tables_.shift_re[m] / h);
    for (std::size_t p = 0; p < pairs; ++p)
      pair_lu_[p].factorize(jacobian_,
                            {tables_.shift_re[real_modes + p] / h, tables_.shift_im[real_modes + p] / h});
  }

  /// Starting values: the polynomial through the stages of the last step, continued.
  void predict(Real h) {
    if (!(last_h_ != 0)) {
      clear_stages(z_);
      if (control_) clear_stages(w_);
      return;
    }
    combine_stages(continuation<starts_at_node>(tables_, h / last_h_), last_z_, z_);
    for (auto& z : z_)
      for_each_component(z, [&](std::size_t n) { z.data()[n] -= last_increment_.data()[n]; });
    if (control_) combine_stages(tables_.into, z_, w_);
  }

  void evaluate_stages(Real t, const State& y, Real h) {
    for (std::size_t i = 0; i < S; ++i) {
      for_each_component(y, [&](std::size_t n) { stage_.data()[n] = y.data()[n] + z_[i].data()[n]; });
      system_.rhs(t + tables_.c[i] * h, stage_, f_[i]);
    }
  }

  /// Overwrites the modes r by the solution of (shift / h - J) x = r.
  void solve_modes() {
    for (std::size_t m = 0; m < real_modes; ++m)
      if (tables_.shift_re[m] != 0) real_lu_[m].solve_in_place(r_[m].data());
    for (std::size_t p = 0; p < pairs; ++p) {
      State &re = r_[real_modes + 2 * p], &im = r_[real_modes + 2 * p + 1];
      for_each_component(re, [&](std::size_t n) { complex_[n] = {re.data()[n], im.data()[n]}; });
      pair_lu_[p].solve_in_place(complex_.data());
      for_each_component(
          re, [&](std::size_t n) { re.data()[n] = complex_[n].re, im.data()[n] = complex_[n].im; });
    }
    ++counts_.newton;
  }
  bool iterate_to_tolerance(Real t, const State& y, Real h) {
    newton_.begin_step(), newton_.begin(h != last_h_);
    for (;;) {
      evaluate_stages(t, y, h);
      if constexpr (is_singular)
        residual_by_stages<real_modes>(tables_, h, f_, z_, r_);
      else
        residual_by_modes<real_modes>(tables_, h, f_, w_, r_);
      solve_modes();
      Real sum = 0;
      for (std::size_t m = 0; m < S; ++m)
        for_each_component(y, [&](std::size_t n) {
          w_[m].data()[n] += r_[m].data()[n];
          const Real ratio = r_[m].data()[n] * weight_.data()[n];
          sum += ratio * ratio;
        });
      const auto verdict = newton_.judge(std::sqrt(sum / Real(S * size_)));
      if (verdict == NewtonVerdict::hopeless) return false;
      combine_stages(tables_.out, w_, z_);
      if (verdict == NewtonVerdict::converged) return true;
    }
  }

  /// `every` refreshes the Jacobian in every iteration, at the middle stage.
  bool iterate_to_round_off(Real t, const State& y, Real h, bool every) {
    RoundOffStop<Real> stop(every ? 48 : 20);
    for (;;) {
      if (every) {
        constexpr std::size_t middle = S / 2;
        for_each_component(y,
                           [&](std::size_t n) { increment_.data()[n] = y.data()[n] + z_[middle].data()[n]; });
        evaluate_jacobian(system_, t + tables_.c[middle] * h, increment_, jacobian_, spare_, more_, stage_);
        factored_h_ = 0;
        factorize(h);
        factored_h_ = 0;
      }
      evaluate_stages(t, y, h);
      residual_by_stages<real_modes>(tables_, h, f_, z_, r_);
      solve_modes();
      combine_stages(tables_.out, r_, w_);
      Real moved = 0, size = 0, terms = 0;
      for (std::size_t i = 0; i < S; ++i)
        for_each_component(y, [&](std::size_t n) {
          z_[i].data()[n] += w_[i].data()[n];
          moved += std::abs(w_[i].data()[n]);
          size += std::abs(z_[i].data()[n]);
          terms += std::abs(y.data()[n]) + std::abs(h * f_[i].data()[n]);
        });
      const auto verdict = stop.judge(moved, size, terms);
      if (verdict != NewtonVerdict::go_on) return verdict == NewtonVerdict::converged;
    }
  }

  void find_increment(Real t, const State& y, Real h) {
    if constexpr (method.stiffly_accurate()) {
      increment_ = z_[S - 1];
    } else if constexpr (is_singular) {
      evaluate_stages(t, y, h);
      for_each_component(y, [&](std::size_t n) {
        Real sum = tables_.b[0] * f_[0].data()[n];
        for (std::size_t j = 1; j < S; ++j) sum += tables_.b[j] * f_[j].data()[n];
        increment_.data()[n] = h * sum;
      });
    } else {
      for_each_component(y, [&](std::size_t n) {
        Real sum = tables_.increment[0] * z_[0].data()[n];
        for (std::size_t j = 1; j < S; ++j) sum += tables_.increment[j] * z_[j].data()[n];
        increment_.data()[n] = sum;
      });
    }
  }

  /// (shift / h - J)^-1 (f(t, y) - slope of the stages' polynomial there): bounded where J is stiff. Where it
  /// says no on a first or repeated step it is asked again at y + estimate, which damps what is stiff twice.
  void estimate(Real t, const State& y, Real h, State& error) {
    if (!start_slope_known_) system_.rhs(t, y, start_slope_);
    start_slope_known_ = true;
    for_each_component(y, [&](std::size_t n) {
      Real sum = tables_.estimate[0] * z_[0].data()[n];
      for (std::size_t j = 1; j < S; ++j) sum += tables_.estimate[j] * z_[j].data()[n];
      spare_.data()[n] = sum / h;
      error.data()[n] = start_slope_.data()[n] + spare_.data()[n];
    });
    if (factored_h_ != h) refresh_jacobian(t, y), factorize(h);  // after Newton proper
    real_lu_[0].solve_in_place(error.data());
    if (!control_) return;
    if ((first_ || rejections_ > 1) && !(newton_.norm(error, y) <= 1)) {
      for_each_component(y, [&](std::size_t n) { stage_.data()[n] = y.data()[n] + error.data()[n]; });
      system_.rhs(t, stage_, error);
      for_each_component(y, [&](std::size_t n) { error.data()[n] += spare_.data()[n]; });
      real_lu_[0].solve_in_place(error.data());
    }
    const Real scale = Real(1 / newton_.tolerance_ratio());
    for_each_component(y, [&](std::size_t n) { error.data()[n] *= scale; });
  }

  const P& system_;
  std::size_t size_;
  const StageTables<Real, S>& tables_;
  JacobianMatrix<Real, N> jacobian_;
  std::array<ShiftedLu<Real, Real, N>, real_modes> real_lu_;
  std::array<ShiftedLu<Real, PlainComplex<Real>, N>, pairs> pair_lu_;
  std::conditional_t<N == 0, std::vector<PlainComplex<Real>>, std::array<PlainComplex<Real>, N>> complex_{};
  Stages z_, w_, f_, r_, last_z_;
  State stage_, weight_, start_slope_, increment_, last_increment_, spare_, more_;
  const ErrorControl* control_ = nullptr;
  NewtonControl<Real> newton_;
  NewtonCounts counts_;
  Real last_h_ = 0, factored_h_ = 0, attempted_h_ = 0;
  int rejections_ = 0;  // attempts since the last accepted step
  bool first_ = true, keep_jacobian_ = false, jacobian_is_current_ = false, start_slope_known_ = false;
};

}  // namespace odemark
