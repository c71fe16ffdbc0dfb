// Explicit Runge-Kutta: one tableau type, one engine.
#pragma once

#include "integrators/compensated.hpp"
#include "integrators/dense_weights.hpp"
#include "integrators/paired_stages.hpp"
#include "integrators/theory.hpp"

namespace odemark {

template <const auto& method, System P>
class ExplicitRungeKuttaStepper;

/// Nodes c are the row sums of `a`; first-same-as-last is read off the rows. Neither can disagree with them.
template <std::size_t Stages>
struct ExplicitRungeKutta {
  static constexpr std::string_view kind_name = "explicit Runge-Kutta";
  static constexpr unsigned needs = 0;
  static constexpr std::size_t stages = Stages;

  std::string_view id, source, note = "", advice = "";
  int order;
  int embedded_order = 0;         // 0: no error estimate
  bool propagates_lower = false;  // embedded_order is order + 1: the better formula only estimates
  std::array<std::array<Coefficient, Stages>, Stages> a{};
  std::array<Coefficient, Stages> b{};
  std::array<Coefficient, Stages> b_embedded{};
  int second_embedded_order = 0;  // 0: one estimate; else two, combined by their norms as in DOP853
  std::array<Coefficient, Stages> b_second_embedded{};
  int dense_order = 0;  // 0: no values between steps; else y + h sum_j b_j(theta) k_j has this order
  /// Stages beyond those of the step that only values between steps need: evaluated when the first is asked
  /// for.
  std::size_t dense_stages = 0;
  std::array<std::array<Coefficient, Stages + most_dense_stages>, most_dense_stages> a_dense{};
  /// b_j(theta) = sum_k dense[j][k] theta^(k+1)
  std::array<std::array<Coefficient, highest_dense_degree>, Stages + most_dense_stages> dense{};

  constexpr Coefficient c(std::size_t stage) const {
    Coefficient sum = 0;
    for (std::size_t j = 0; j < stage; ++j) sum += a[stage][j];
    return sum;
  }
  constexpr bool first_same_as_last() const { return Stages > 1 && a[Stages - 1] == b; }
  constexpr bool has_error_estimate() const { return embedded_order > 0; }
  constexpr bool has_second_estimate() const { return second_embedded_order > 0; }
  /// The power of h that the estimate goes with. Two estimates of h^(q+1) and h^(r+1), r < q, are combined to
  /// |e_q|^2 / sqrt(|e_q|^2 + 0.01 |e_r|^2) ~ h^(2q - r + 1) (E. Hairer, S. P. Norsett, G. Wanner, Solving
  /// ODEs I, II.10).
  constexpr int error_order() const {
    return has_second_estimate() ? 2 * embedded_order - second_embedded_order + 1
                                 : (embedded_order < order ? embedded_order : order) + 1;
  }
  Theory theory() const {
    Theory theory = runge_kutta_theory(a, b, embedded_order > 0 ? &b_embedded : nullptr);
    theory.rounding_amplification = sum_of_magnitudes(b);
    return theory;
  }

  template <const auto& method, System P>
  using Stepper = ExplicitRungeKuttaStepper<method, P>;
};

/// Written for the compiler: for a state of fixed size every stage and slope is a fresh local, so that
/// nothing is kept in memory between stages (a reused array costs GCC a store-forwarding stall per stage, 3
/// to 7 times the step). States of run-time size use slopes allocated once; the arithmetic is the same, bit
/// for bit.
template <const auto& method, System P>
class ExplicitRungeKuttaStepper {
 public:
  using State = typename P::State;
  using Component = ComponentOf<State>;
  using Real = RealOf<State>;

  ExplicitRungeKuttaStepper(const P& system, const State& model)
      : system_(system), first_(blank_like(model)), last_(blank_like(model)) {
    if constexpr (!is_fixed) {
      slopes_.fill(model), dense_slopes_.fill(model);
      stage_ = increment_ = model;
      if constexpr (method.has_second_estimate()) second_ = model;
    }
  }

  void start() { first_known_ = false; }

  [[gnu::always_inline]] StepStatus attempt(Real t, const State& y, Real h, State& next, State& error) {
    if (!first_known_) system_.rhs(t, y, first_);
    first_known_ = true;  // still f(t, y) if this attempt is rejected
    dense_known_ = method.dense_stages == 0;
    if constexpr (in_pairs) {
      paired_.take_step(system_, t, y, h, State(first_), next, error, second_, last_);
    } else if constexpr (is_fixed) {
      evaluate_from<1>(t, y, h, next, error, State(first_));
    } else {
      evaluate_stored(t, y, h, next);
      if constexpr (method.has_error_estimate()) [&]<std::size_t... J>(std::index_sequence<J...>) {
          estimate(h, error, slope<J>()...);
        }
      (std::make_index_sequence<method.stages>{});
    }
    return StepStatus::ok;
  }

  void accept() {
    if constexpr (method.first_same_as_last()) {
      if constexpr (is_fixed)
        first_ = last_;
      else
        std::swap(first_, slopes_.back());
    } else {
      first_known_ = false;
    }
  }

  /// The other estimate of the last attempt, where the method has two: see combined_square in
  /// integrators/integrate.hpp.
  const State& second_error() const requires(method.has_second_estimate()) { return second_; }

  /// y(t + theta h) from the slopes of the last attempt, before accept(): no evaluation, but for the first
  /// value of a step where the method has dense stages. For states of run-time size, whose slopes are stored.
  void interpolate(Real t, Real theta, const State& y, Real h, State& out)  //
      requires(method.dense_order > 0 && fixed_size<State> == 0) {
    evaluate_dense_stages(t, y, h);
    std::array<Real, method.stages + most_dense_stages> weights{};
    for (std::size_t j = 0; j < method.stages + method.dense_stages; ++j) {
      for (std::size_t k = highest_dense_degree; k-- > 0;)
        weights[j] = (weights[j] + static_cast<Real>(method.dense[j][k])) * theta;
      weights[j] *= h;
    }
    combine_dense(y, weights, method.stages + method.dense_stages, out);
  }

  StepStatus attempt_compensated(Real t, const State& y, const State& carry, Real h, State& next,
                                 State& next_carry) requires(fixed_size<State> == 0) {
    if (!first_known_) system_.rhs(t, y, first_);
    first_known_ = true;
    evaluate_stored(t, y, h, next);
    [&]<std::size_t... J>(std::index_sequence<J...>) { weighted<MainWeights>(h, increment_, slope<J>()...); }
    (std::make_index_sequence<method.stages>{});
    add_compensated(y, carry, increment_, next, next_carry);
    return StepStatus::ok;
  }

 private:
  static constexpr bool is_fixed = fixed_size<State> > 0;

  static constexpr bool in_pairs = has_paired_stages<method, State>;
  struct NotPaired {};

  template <std::size_t I>
  using RowWeights = TableauRow<method, I>;
  using MainWeights = RowWeights<RowWeights<0>::step>;
  using ErrorWeights = RowWeights<RowWeights<0>::error>;
  using SecondErrorWeights = RowWeights<RowWeights<0>::second_error>;

  template <std::size_t I, class... Slopes>
  [[gnu::always_inline]] void evaluate_from(Real t, const State& y, Real h, State& next, State& error,
                                            const Slopes&... k) {
    if constexpr (I < method.stages) {
      State u;
      advance<RowWeights<I>>(y, h, u, k...);
      State slope;
      system_.rhs(t + static_cast<Real>(method.c(I)) * h, u, slope);
      if constexpr (I + 1 == method.stages && method.first_same_as_last()) next = u;
      evaluate_from<I + 1>(t, y, h, next, error, k..., slope);
    } else {
      if constexpr (method.first_same_as_last())
        last_ = std::get<method.stages - 1>(std::tie(k...));
      else
        advance<MainWeights>(y, h, next, k...);
      if constexpr (method.has_error_estimate()) estimate(h, error, k...);
    }
  }

  template <std::size_t J>
  State& slope() {
    if constexpr (J == 0)
      return first_;
    else
      return slopes_[J];
  }

  const State& dense_slope(std::size_t j) const {
    return j == 0 ? first_ : j < method.stages ? slopes_[j] : dense_slopes_[j - method.stages];
  }
  void combine_dense(const State& y, const std::array<Real, method.stages + most_dense_stages>& weights,
                     std::size_t count, State& out) const {
    for_each_component(y, [&](std::size_t i) {
      Component sum = y.data()[i];
      for (std::size_t j = 0; j < count; ++j) sum = sum + weights[j] * dense_slope(j).data()[i];
      out.data()[i] = sum;
    });
  }
  void evaluate_dense_stages(Real t, const State& y, Real h) {
    if (dense_known_) return;
    dense_known_ = true;
    for (std::size_t d = 0; d < method.dense_stages; ++d) {
      std::array<Real, method.stages + most_dense_stages> weights{};
      Coefficient node = 0;
      for (std::size_t j = 0; j < method.stages + d; ++j) {
        node += method.a_dense[d][j];
        weights[j] = h * static_cast<Real>(method.a_dense[d][j]);
      }
      combine_dense(y, weights, method.stages + d, stage_);
      system_.rhs(t + static_cast<Real>(node) * h, stage_, dense_slopes_[d]);
    }
  }

  void evaluate_stored(Real t, const State& y, Real h, State& next) {
    [&]<std::size_t... I>(std::index_sequence<I...>) { (evaluate_stage<I + 1>(t, y, h, next), ...); }
    (std::make_index_sequence<method.stages - 1>{});
    if constexpr (!method.first_same_as_last()) [&]<std::size_t... J>(std::index_sequence<J...>) {
        advance<MainWeights>(y, h, next, slope<J>()...);
      }
    (std::make_index_sequence<method.stages>{});
  }
  template <std::size_t I>
  void evaluate_stage(Real t, const State& y, Real h, State& next) {
    State& u = I + 1 == method.stages && method.first_same_as_last() ? next : stage_;
    [&]<std::size_t... J>(std::index_sequence<J...>) { advance<RowWeights<I>>(y, h, u, slope<J>()...); }
    (std::make_index_sequence<I>{});
    system_.rhs(t + static_cast<Real>(method.c(I)) * h, u, slope<I>());
  }

  /// out = base + (h w_0) k_0 + (h w_1) k_1 + ..., from the base, the newest slope last.
  template <class Weights, class... Slopes>
  [[gnu::always_inline]] static void advance(const State& base, Real h, State& out, const Slopes&... k) {
    constexpr auto used = nonzero_weights<Weights, sizeof...(Slopes)>();
    const auto slopes = std::tie(k...);
    [&]<std::size_t... U>(std::index_sequence<U...>) __attribute__((always_inline)) {
      const std::array<Real, used.size()> scaled{h * static_cast<Real>(Weights::value(used[U]))...};
      for_each_component(base, [&](std::size_t i) {
        Component sum = base.data()[i];
        ((sum = sum + scaled[U] * std::get<used[U]>(slopes).data()[i]), ...);
        out.data()[i] = sum;
      });
    }
    (std::make_index_sequence<used.size()>{});
  }

  /// out = (h w_0) k_0 + (h w_1) k_1 + ...
  template <class Weights, class... Slopes>
  [[gnu::always_inline]] static void weighted(Real h, State& out, const Slopes&... k) {
    constexpr auto used = nonzero_weights<Weights, sizeof...(Slopes)>();
    const auto slopes = std::tie(k...);
    [&]<std::size_t... U>(std::index_sequence<U...>) __attribute__((always_inline)) {
      const std::array<Real, used.size()> scaled{h * static_cast<Real>(Weights::value(used[U]))...};
      for_each_component(out, [&](std::size_t i) {
        out.data()[i] = (... + (scaled[U] * std::get<used[U]>(slopes).data()[i]));
      });
    }
    (std::make_index_sequence<used.size()>{});
  }
  template <class... Slopes>
  [[gnu::always_inline]] void estimate(Real h, State& error, const Slopes&... k) {
    weighted<ErrorWeights>(h, error, k...);
    if constexpr (method.has_second_estimate()) weighted<SecondErrorWeights>(h, second_, k...);
  }

  const P& system_;
  State first_, last_;  // f(t, y) of this step; f at its end where the last stage is the next first
  State stage_{}, increment_{}, second_{};
  std::array<State, is_fixed ? 0 : method.stages> slopes_{};
  std::array<State, is_fixed ? 0 : method.dense_stages> dense_slopes_{};
  std::conditional_t<in_pairs, PairedStages<method, P>, NotPaired> paired_{};
  bool first_known_ = false, dense_known_ = true;
};

}  // namespace odemark
