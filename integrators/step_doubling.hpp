// Step doubling: one step of h against two of h/2, for a base method without an estimate of its own.
#pragma once

#include "integrators/theory.hpp"

namespace odemark {

template <const auto& method, System P>
class StepDoublingStepper;

/// Keeps the two half steps; the error estimate of that result is the difference over 2^p - 1 (Hairer,
/// Norsett & Wanner, Solving ODEs I, II.4).
template <const auto& base>
struct StepDoubling {
  static constexpr std::string_view kind_name = "step doubling";
  static constexpr unsigned needs = KindOf<base>::needs;

  std::string_view id, source;
  int order = base.order;
  int embedded_order = base.order;

  /// Two half steps: R(z/2)^2.
  Theory theory() const {
    const Theory half = base.theory();
    const auto squared = [](const std::vector<Coefficient>& p) {
      std::vector<Coefficient> square(2 * p.size() - 1, 0);
      for (std::size_t i = 0; i < p.size(); ++i)
        for (std::size_t j = 0; j < p.size(); ++j) {
          Coefficient scale = 1;
          for (std::size_t k = 0; k < i + j; ++k) scale /= 2;
          square[i + j] += scale * p[i] * p[j];
        }
      return square;
    };
    Theory theory;
    theory.numerator = squared(half.numerator);
    theory.denominator = squared(half.denominator);
    return theory;
  }

  template <const auto& method, System P>
  using Stepper = StepDoublingStepper<method, P>;
  template <class P>
  using BaseStepper = StepperOf<base, P>;
};

template <const auto& method, System P>
class StepDoublingStepper {
 public:
  using State = typename P::State;
  using Real = RealOf<State>;

  StepDoublingStepper(const P& system, const State& model)
      : whole_(system, model), half_(system, model), big_(model), middle_(model) {}

  void start() { whole_.start(), half_.start(); }
  void accept() {}

  StepStatus attempt(Real t, const State& y, Real h, State& next, State& error) {
    whole_.start(), half_.start();
    if (whole_.attempt(t, y, h, big_, error) != StepStatus::ok) return StepStatus::newton_diverged;
    if (half_.attempt(t, y, h / 2, middle_, error) != StepStatus::ok) return StepStatus::newton_diverged;
    half_.accept();
    if (half_.attempt(t + h / 2, middle_, h / 2, next, error) != StepStatus::ok)
      return StepStatus::newton_diverged;
    constexpr Real power = Real((1L << method.order) - 1);
    for_each_component(y,
                       [&](std::size_t i) { error.data()[i] = (next.data()[i] - big_.data()[i]) / power; });
    return StepStatus::ok;
  }

 private:
  typename KindOf<method>::template BaseStepper<P> whole_, half_;
  State big_, middle_;
};

}  // namespace odemark
