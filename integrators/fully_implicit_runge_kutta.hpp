// Fully implicit Runge-Kutta methods as data: Gauss, Radau, Lobatto.
#pragma once

#include "integrators/collocation_tableau.hpp"
#include "integrators/theory.hpp"

namespace odemark {

template <const auto& method, System P>
class FullyImplicitRungeKuttaStepper;

/// Nodes c are the row sums of `a`. Where `embedded_order` is given, it is the number of stages, and the
/// error is estimated by comparing with f at the start of the step, filtered through the Newton matrix of the
/// real eigenvalue of A (E. Hairer, G. Wanner, Solving ODEs II, IV.8, eq. 8.19-8.20): for that there must be
/// one.
template <std::size_t Stages>
struct FullyImplicitRungeKutta {
  static constexpr std::string_view kind_name = "fully implicit Runge-Kutta";
  static constexpr unsigned needs = 0;
  static constexpr bool solves_equations = true;
  static constexpr std::size_t stages = Stages;

  std::string_view id, source;
  int order;
  int embedded_order = 0;
  bool jumps_over_poles = false;  // see AnyMethod
  StageMatrix<Stages> a{};
  StageVector<Stages> b{};
  std::string_view note = "", advice = "";
  std::size_t real_modes = Stages % 2;  // real eigenvalues of A; the others come in pairs

  constexpr Coefficient c(std::size_t stage) const {
    Coefficient sum = 0;
    for (std::size_t j = 0; j < Stages; ++j) sum += a[stage][j];
    return sum;
  }
  constexpr bool stiffly_accurate() const { return a[Stages - 1] == b; }
  /// A zero row (an explicit stage) or a zero column; the only ways in which these families are singular.
  constexpr bool is_singular() const {
    for (std::size_t i = 0; i < Stages; ++i) {
      bool row = true, column = true;
      for (std::size_t j = 0; j < Stages; ++j) row = row && a[i][j] == 0, column = column && a[j][i] == 0;
      if (row || column) return true;
    }
    return false;
  }
  Theory theory() const {
    Theory theory = runge_kutta_theory(a, b);
    if (embedded_order > 0) compare_with_start(theory);
    return theory;
  }

  template <const auto& method, System P>
  using Stepper = FullyImplicitRungeKuttaStepper<method, P>;
};

/// Exactly the order claimed, by simplifying assumptions; an estimate of the order of the stages needs one
/// real mode.
template <std::size_t S>
constexpr bool orders_hold(const FullyImplicitRungeKutta<S>& m) {
  return simplifying_assumptions<S>(m.a, m.b).proved_order() == m.order &&
         (m.embedded_order == 0 || (m.embedded_order == int(S) && m.real_modes == 1 && !m.is_singular()));
}

}  // namespace odemark

#include "integrators/fully_implicit_stepper.hpp"
