// Linear multistep methods as data: formulas, their orders, and the kinds built from them.
#pragma once

#include "integrators/theory.hpp"

namespace odemark {

/// y_{n+1} = sum_j states[j] y_{n-j} + h (next_slope f_{n+1} + sum_j slopes[j] f_{n-j}): newest first.
template <std::size_t Steps>
struct MultistepFormula {
  std::array<Coefficient, Steps> states{1};  // Adams: y_n alone
  Coefficient next_slope = 0;                // 0: explicit
  std::array<Coefficient, Steps> slopes{};

  /// How many past states beyond y_n and how many slopes, f_n among them, the formula looks at.
  constexpr std::size_t past_states() const { return std::max<std::size_t>(used(states), 1) - 1; }
  constexpr std::size_t slope_count() const { return used(slopes); }

  /// The largest p with sum_j states[j] (-j)^q + q (next_slope + sum_j slopes[j] (-j)^(q-1)) = 1 for q <= p
  /// (Hairer, Norsett & Wanner, Solving ODEs I, III.2, theorem 2.4).
  constexpr int order() const {
    for (int q = 0; q <= int(2 * Steps) + 2; ++q) {
      Coefficient sum = q > 0 ? Coefficient(q) * next_slope : 0, size = 1 + std::max(sum, -sum);
      for (std::size_t j = 0; j < Steps; ++j) {
        const Coefficient terms[2] = {states[j] * power(j, q),
                                      q > 0 ? Coefficient(q) * slopes[j] * power(j, q - 1) : 0};
        for (const Coefficient term : terms) sum += term, size += std::max(term, -term);
      }
      const Coefficient residual = sum - 1;
      if (!(residual <= 1e-17L * size && residual >= -1e-17L * size)) return q - 1;
    }
    return int(2 * Steps) + 2;
  }

 private:
  static constexpr std::size_t used(const std::array<Coefficient, Steps>& weights) {
    std::size_t count = Steps;
    while (count > 0 && weights[count - 1] == 0) --count;
    return count;
  }
  static constexpr Coefficient power(std::size_t j, int exponent) {
    Coefficient out = 1;
    for (int i = 0; i < exponent; ++i) out *= -Coefficient(j);
    return out;
  }
};

/// The same formula among more steps, so that it can be paired with a longer one.
template <std::size_t Wide, std::size_t Steps>
constexpr MultistepFormula<Wide> widened(const MultistepFormula<Steps>& narrow) {
  static_assert(Wide >= Steps);
  MultistepFormula<Wide> wide;
  wide.states[0] = 0;
  for (std::size_t j = 0; j < Steps; ++j)
    wide.states[j] = narrow.states[j], wide.slopes[j] = narrow.slopes[j];
  wide.next_slope = narrow.next_slope;
  return wide;
}

template <const auto& method, System P>
class MultistepStepper;
template <const auto& method, System P>
class ImplicitMultistepStepper;
template <const auto& method, System P>
class PredictorCorrectorStepper;

/// Fixed steps only; the first ones are taken by `starter`, whose order must match (a history of copies of
/// f(0) costs an order, and every order above the second).
template <std::size_t Steps, const auto& starter, bool Implicit>
struct LinearMultistep {
  static constexpr std::string_view kind_name = Implicit ? "implicit multistep" : "explicit multistep";
  static constexpr unsigned needs = 0;
  static constexpr bool solves_equations = Implicit;
  static constexpr std::string_view starter_id() { return starter.id; }

  std::string_view id, source;
  std::string_view advice = "";
  int order;
  int embedded_order = 0;
  MultistepFormula<Steps> formula;

  constexpr int proven_order() const { return formula.order(); }
  constexpr bool start_suffices() const { return starter.order >= order; }
  constexpr bool form_holds() const { return (formula.next_slope != 0) == Implicit; }
  constexpr std::size_t past_states() const { return formula.past_states(); }
  constexpr std::size_t slope_count() const { return formula.slope_count(); }

  Theory theory() const {
    Theory theory;
    theory.rho.assign(Steps + 1, 0), theory.sigma.assign(Steps + 1, 0);
    theory.rho[Steps] = 1, theory.sigma[Steps] = formula.next_slope;
    for (std::size_t j = 0; j < Steps; ++j)
      theory.rho[Steps - 1 - j] = -formula.states[j], theory.sigma[Steps - 1 - j] = formula.slopes[j];
    return theory;
  }

  template <const auto& method, System P>
  using Stepper =
      std::conditional_t<Implicit, ImplicitMultistepStepper<method, P>, MultistepStepper<method, P>>;
  template <class P>
  using Starter = StepperOf<starter, P>;
};

template <std::size_t Steps, const auto& starter>
using ExplicitMultistep = LinearMultistep<Steps, starter, false>;
template <std::size_t Steps, const auto& starter>
using ImplicitMultistep = LinearMultistep<Steps, starter, true>;

/// PECE: predict with one formula, evaluate there, correct once with the other, evaluate again.
template <std::size_t Steps, const auto& starter>
struct PredictorCorrector {
  static constexpr std::string_view kind_name = "predictor-corrector";
  static constexpr unsigned needs = 0;
  static constexpr std::string_view starter_id() { return starter.id; }

  std::string_view id, source;
  std::string_view advice = "";
  int order;
  int embedded_order = 0;
  MultistepFormula<Steps> predictor, corrector;

  /// One correction raises what a prediction is good for by one power of h (HNW I, III.8).
  constexpr int proven_order() const { return std::min(predictor.order() + 1, corrector.order()); }
  constexpr bool start_suffices() const { return starter.order >= order; }
  constexpr bool form_holds() const { return predictor.next_slope == 0 && corrector.next_slope != 0; }
  constexpr std::size_t past_states() const {
    return std::max(predictor.past_states(), corrector.past_states());
  }
  constexpr std::size_t slope_count() const {
    return std::max(predictor.slope_count(), corrector.slope_count());
  }

  /// w^k - sum_j (a_j + z c_j + z b (a*_j + z c*_j)) w^(k-1-j), starred of the predictor.
  Theory theory() const {
    Theory theory;
    theory.characteristic.assign(3, std::vector<Coefficient>(Steps + 1, 0));
    theory.characteristic[0][Steps] = 1;
    const Coefficient b = corrector.next_slope;
    for (std::size_t j = 0; j < Steps; ++j) {
      const std::size_t w = Steps - 1 - j;
      theory.characteristic[0][w] = -corrector.states[j];
      theory.characteristic[1][w] = -corrector.slopes[j] - b * predictor.states[j];
      theory.characteristic[2][w] = -b * predictor.slopes[j];
    }
    return theory;
  }

  template <const auto& method, System P>
  using Stepper = PredictorCorrectorStepper<method, P>;
  template <class P>
  using Starter = StepperOf<starter, P>;
};

/// Is the order as claimed, and the starter good enough for it? A wrong weight or a poor starter does not
/// compile.
template <class Method>
constexpr bool multistep_holds(const Method& m) {
  return m.form_holds() && m.proven_order() == m.order && m.start_suffices();
}

}  // namespace odemark

#include "integrators/multistep_stepper.hpp"
