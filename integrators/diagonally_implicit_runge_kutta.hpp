// Diagonally implicit Runge-Kutta: stage-by-stage simplified Newton, one factorization per diagonal entry.
#pragma once

#include "integrators/compensated.hpp"
#include "integrators/dense_lu.hpp"
#include "integrators/jacobian.hpp"
#include "integrators/theory.hpp"

namespace odemark {

template <const auto& method, System P>
class DiagonallyImplicitRungeKuttaStepper;

/// A zero on the diagonal makes its stage explicit (the trapezoid's first).
template <std::size_t Stages>
struct DiagonallyImplicitRungeKutta {
  static constexpr std::string_view kind_name = "diagonally implicit Runge-Kutta";
  static constexpr unsigned needs = 0;
  static constexpr std::size_t stages = Stages;

  std::string_view id, source;
  int order;
  int embedded_order = 0;
  std::array<std::array<Coefficient, Stages>, Stages> a{};
  std::array<Coefficient, Stages> b{};
  std::array<Coefficient, Stages> b_embedded{};

  constexpr Coefficient c(std::size_t stage) const {
    Coefficient sum = 0;
    for (std::size_t j = 0; j <= stage; ++j) sum += a[stage][j];
    return sum;
  }
  /// The last stage is the new state: nothing is lost where f is stiff.
  constexpr bool stiffly_accurate() const { return a[Stages - 1] == b; }
  Theory theory() const { return runge_kutta_theory(a, b, embedded_order > 0 ? &b_embedded : nullptr); }

  template <const auto& method, System P>
  using Stepper = DiagonallyImplicitRungeKuttaStepper<method, P>;
};

template <const auto& method, System P>
class DiagonallyImplicitRungeKuttaStepper {
 public:
  using State = typename P::State;
  using Real = RealOf<State>;

  DiagonallyImplicitRungeKuttaStepper(const P& system, const State& model)
      : system_(system),
        size_(size_of(model)),
        stage_(model),
        base_(model),
        spare_(model),
        correction_(model),
        increment_(model),
        lu_(size_) {
    slopes_.fill(zeros_like(model));
  }

  void start() {}
  void accept() {}
  NewtonCounts newton_counts() const { return counts_; }

  StepStatus attempt(Real t, const State& y, Real h, State& next, State& error) {
    if (!solve_stages(t, y, h)) return StepStatus::newton_diverged;
    if constexpr (method.stiffly_accurate() && method.a[method.stages - 1][method.stages - 1] != 0)
      next = stage_;
    else
      combine(y, h, next);
    if constexpr (method.embedded_order > 0)
      for_each_component(y, [&](std::size_t n) {
        Real sum = 0;
        for (std::size_t j = 0; j < method.stages; ++j)
          sum += h * static_cast<Real>(method.b[j] - method.b_embedded[j]) * slopes_[j].data()[n];
        error.data()[n] = sum;
      });
    return StepStatus::ok;
  }

  StepStatus attempt_compensated(Real t, const State& y, const State& carry, Real h, State& next,
                                 State& next_carry) {
    if (!solve_stages(t, y, h)) return StepStatus::newton_diverged;
    for_each_component(y, [&](std::size_t n) { increment_.data()[n] = Real(0); });
    combine(increment_, h, increment_);
    add_compensated(y, carry, increment_, next, next_carry);
    return StepStatus::ok;
  }

 private:
  static constexpr int most_iterations = 12;

  void combine(const State& base, Real h, State& out) const {
    for_each_component(base, [&](std::size_t n) {
      Real sum = base.data()[n];
      for (std::size_t j = 0; j < method.stages; ++j)
        sum += h * static_cast<Real>(method.b[j]) * slopes_[j].data()[n];
      out.data()[n] = sum;
    });
  }

  bool solve_stages(Real t, const State& y, Real h) {
    refresh_jacobian(t, y);
    factored_ = std::numeric_limits<Real>::quiet_NaN();
    stage_ = y;
    for (std::size_t i = 0; i < method.stages; ++i) {
      const Real diagonal = h * static_cast<Real>(method.a[i][i]);
      const Real stage_time = t + static_cast<Real>(method.c(i)) * h;
      for_each_component(y, [&](std::size_t n) {
        Real sum = y.data()[n];
        for (std::size_t j = 0; j < i; ++j)
          sum += h * static_cast<Real>(method.a[i][j]) * slopes_[j].data()[n];
        base_.data()[n] = sum;
      });
      if (method.a[i][i] == 0) {
        system_.rhs(stage_time, base_, slopes_[i]);
        continue;
      }
      if (!solve_stage(i, stage_time, diagonal)) {
        // the Jacobian of the start may be far from that of the stage: once more, with Newton proper
        stage_ = y;
        if (!solve_stage(i, stage_time, diagonal, true)) return false;
      }
    }
    return true;
  }

  void refresh_jacobian(Real t, const State& y) {
    evaluate_jacobian(system_, t, y, MatrixView<Real>{lu_.jacobian(), size_}, spare_, correction_,
                      increment_);
  }
  void factorize(Real diagonal) {
    lu_.factorize(factored_ = diagonal);
    ++counts_.lu;
  }

  /// Find stage = base + diagonal * f(stage); the slope is then (stage - base) / diagonal: no further
  /// evaluation, and exact where f is stiff. `every` refreshes the Jacobian in every iteration.
  bool solve_stage(std::size_t i, Real stage_time, Real diagonal, bool every = false) {
    const Real tolerance = 4 * std::numeric_limits<Real>::epsilon();
    Real previous = std::numeric_limits<Real>::infinity();
    for (int iteration = 0; iteration < most_iterations * (every ? 4 : 1); ++iteration) {
      if (every) {
        refresh_jacobian(stage_time, stage_);
        factorize(diagonal);
      } else if (!(factored_ == diagonal)) {
        factorize(diagonal);
      }
      system_.rhs(stage_time, stage_, slopes_[i]);
      for_each_component(stage_, [&](std::size_t n) {
        correction_.data()[n] = base_.data()[n] + diagonal * slopes_[i].data()[n] - stage_.data()[n];
      });
      lu_.solve_in_place(correction_.data());
      ++counts_.newton;
      Real moved = 0, scale = std::numeric_limits<Real>::min();  // sums, because std::max would swallow a NaN
      Real terms = 0;  // what the stage is the small difference of, where the step is long
      for_each_component(stage_, [&](std::size_t n) {
        stage_.data()[n] += correction_.data()[n];
        moved += std::abs(correction_.data()[n]);
        scale += std::abs(stage_.data()[n]);
        terms += std::abs(base_.data()[n]) + std::abs(diagonal * slopes_[i].data()[n]);
      });
      if (!std::isfinite(moved + scale)) return false;
      // done, or as far as rounding lets it come: corrections that no longer shrink and are small already
      const bool stalled = moved >= previous / 2 && moved <= 1024 * tolerance * (scale + terms);
      if (moved <= tolerance * scale || stalled) {
        for_each_component(stage_, [&](std::size_t n) {
          slopes_[i].data()[n] = (stage_.data()[n] - base_.data()[n]) / diagonal;
        });
        return true;
      }
      if (!every && iteration > 2 && moved > 2 * previous) return false;
      previous = moved;
    }
    return false;
  }

  const P& system_;
  std::size_t size_;
  std::array<State, method.stages> slopes_;
  State stage_, base_, spare_, correction_, increment_;
  DenseLu<Real> lu_;
  Real factored_ = std::numeric_limits<Real>::quiet_NaN();
  NewtonCounts counts_;
};

}  // namespace odemark
