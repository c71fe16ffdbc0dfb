// Diagonally implicit Runge-Kutta methods as data: SDIRK, ESDIRK and their kin.
#pragma once

#include "integrators/theory.hpp"

namespace odemark {

template <const auto& method, System P>
class DiagonallyImplicitRungeKuttaStepper;

/// A zero on the diagonal makes its stage explicit (the trapezoid's first). `filter_estimate` sends the error
/// estimate once through the Newton matrix (E. Hairer, G. Wanner, Solving ODEs II, IV.8, eq. 8.20): for
/// embedded methods that are not stable at infinity, whose bare estimate is wild where f is stiff.
template <std::size_t Stages>
struct DiagonallyImplicitRungeKutta {
  static constexpr std::string_view kind_name = "diagonally implicit Runge-Kutta";
  static constexpr unsigned needs = 0;
  static constexpr bool solves_equations = true;
  static constexpr std::size_t stages = Stages;

  std::string_view id, source;
  int order;
  int embedded_order = 0;
  bool propagates_lower = false;  // embedded_order is order + 1
  std::array<std::array<Coefficient, Stages>, Stages> a{};
  std::array<Coefficient, Stages> b{};
  std::array<Coefficient, Stages> b_embedded{};
  bool filter_estimate = false;
  std::string_view advice = "";

  constexpr Coefficient c(std::size_t stage) const {
    Coefficient sum = 0;
    for (std::size_t j = 0; j <= stage; ++j) sum += a[stage][j];
    return sum;
  }
  /// The last stage is the new state: nothing is lost where f is stiff.
  constexpr bool stiffly_accurate() const { return a[Stages - 1] == b; }
  /// The matrix that filters the estimate is the one that was factored last.
  constexpr Coefficient filter_gamma() const {
    Coefficient gamma = 0;
    for (std::size_t i = 0; i < Stages; ++i)
      if (filter_estimate && a[i][i] != 0) gamma = a[i][i];
    return gamma;
  }
  Theory theory() const {
    Theory theory = runge_kutta_theory(a, b, embedded_order > 0 ? &b_embedded : nullptr);
    theory.estimate_filter = filter_gamma();
    return theory;
  }

  template <const auto& method, System P>
  using Stepper = DiagonallyImplicitRungeKuttaStepper<method, P>;
};

}  // namespace odemark

#include "integrators/diagonally_implicit_stepper.hpp"
