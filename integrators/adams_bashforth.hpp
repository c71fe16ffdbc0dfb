// Explicit linear multistep: one row of weights, a ring of past slopes, a named starter.
#pragma once

#include "integrators/compensated.hpp"
#include "integrators/theory.hpp"

namespace odemark {

template <const auto& method, System P>
class AdamsBashforthStepper;

/// y_{n+1} = y_n + h sum_j weights[j] f_{n-j}. Fixed steps only; the first ones are taken by `starter`, whose
/// order must match (a history of copies of f(0) costs an order, and every order above the second).
template <std::size_t Steps, const auto& starter>
struct AdamsBashforth {
  static constexpr std::string_view kind_name = "Adams-Bashforth";
  static constexpr unsigned needs = 0;
  static constexpr std::size_t steps = Steps;
  static constexpr std::string_view starter_id() { return starter.id; }

  std::string_view id, source;
  int order;
  int embedded_order = 0;
  std::array<Coefficient, Steps> weights{};  // newest slope first

  Theory theory() const {
    Theory theory;
    theory.rho.assign(Steps + 1, 0);
    theory.rho[Steps] = 1, theory.rho[Steps - 1] = -1;
    theory.sigma.assign(Steps + 1, 0);
    for (std::size_t j = 0; j < Steps; ++j) theory.sigma[Steps - 1 - j] = weights[j];
    return theory;
  }

  template <const auto& method, System P>
  using Stepper = AdamsBashforthStepper<method, P>;
  template <class P>
  using Starter = StepperOf<starter, P>;
};

/// Is the order as claimed? sum_j weights[j] (-j)^q = 1 / (q + 1) for q < order, and not for q = order.
template <class Method>
constexpr bool adams_order_holds(const Method& m) {
  for (int q = 0; q <= m.order; ++q) {
    Coefficient sum = 0;
    for (std::size_t j = 0; j < Method::steps; ++j) {
      Coefficient power = 1;
      for (int i = 0; i < q; ++i) power *= -Coefficient(j);
      sum += m.weights[j] * power;
    }
    const Coefficient residual = sum - 1.0L / Coefficient(q + 1);
    const bool vanishes = residual < 1e-16L && residual > -1e-16L;
    if (vanishes != (q < m.order)) return false;
  }
  return true;
}

template <const auto& method, System P>
class AdamsBashforthStepper {
 public:
  using State = typename P::State;
  using Real = RealOf<State>;

  AdamsBashforthStepper(const P& system, const State& model)
      : system_(system), starter_(system, model), increment_(blank_like(model)) {
    slopes_.fill(zeros_like(model));
  }

  void start() { known_ = 0, newest_ = 0, starter_.start(); }
  std::size_t history_length() const { return method.steps - 1; }
  State& history(std::size_t k) { return slopes_[(newest_ + 2 * method.steps - 1 - k) % method.steps]; }
  void assume_history() { known_ = method.steps - 1; }

  StepStatus attempt(Real t, const State& y, Real h, State& next, State& error) {
    system_.rhs(t, y, slopes_[newest_]);
    if (known_ + 1 < method.steps) return starter_.attempt(t, y, h, next, error);
    with_slopes(
        [&](const auto& scaled, const auto&... slope) {
          for_each_component(y, [&](std::size_t i) {
            auto sum = y.data()[i];
            std::size_t j = 0;
            ((sum = sum + scaled[j++] * slope.data()[i]), ...);
            next.data()[i] = sum;
          });
        },
        h);
    return StepStatus::ok;
  }

  StepStatus attempt_compensated(Real t, const State& y, const State& carry, Real h, State& next,
                                 State& next_carry) requires
      CompensatedStepper<typename KindOf<method>::template Starter<P>> {
    system_.rhs(t, y, slopes_[newest_]);
    if (known_ + 1 < method.steps) return starter_.attempt_compensated(t, y, carry, h, next, next_carry);
    with_slopes(
        [&](const auto& scaled, const auto&... slope) {
          for_each_component(y, [&](std::size_t i) {
            std::size_t j = 0;
            auto sum = ComponentOf<State>(0);
            ((sum = sum + scaled[j++] * slope.data()[i]), ...);
            increment_.data()[i] = sum;
          });
        },
        h);
    add_compensated(y, carry, increment_, next, next_carry);
    return StepStatus::ok;
  }

  void accept() {
    if (known_ + 1 < method.steps) ++known_, starter_.start();
    newest_ = (newest_ + 1) % method.steps;
  }

 private:
  /// Calls f(h * weights, slopes), oldest first, so that only the last addition waits for the newest slope.
  template <class F>
  void with_slopes(F&& f, Real h) {
    [&]<std::size_t... J>(std::index_sequence<J...>) {
      const std::array<Real, method.steps> scaled{h *
                                                  static_cast<Real>(method.weights[method.steps - 1 - J])...};
      f(scaled, slopes_[(newest_ + 1 + J) % method.steps]...);
    }
    (std::make_index_sequence<method.steps>{});
  }

  const P& system_;
  typename KindOf<method>::template Starter<P> starter_;
  State increment_;
  std::array<State, method.steps> slopes_;  // ring: newest_ is the place of f_n
  std::size_t known_ = 0, newest_ = 0;
};

}  // namespace odemark
