// Backward differentiation of variable order and step: the data, and what follows from them.
#pragma once

#include "integrators/bdf_driver.hpp"
#include "integrators/extrapolation.hpp"

namespace odemark {

/// Orders 1 to 5 in backward differences, step held until order + 1 steps have been equal, then rescaled by
/// interpolation. kappa[k] 0 gives the BDF; other values trade angle of stability for a smaller error
/// constant (R. W. Klopfenstein, RCA Review 32 (1971) 447-462).
struct VariableOrderBdf {
  static constexpr std::string_view kind_name = "variable-order BDF";
  static constexpr unsigned needs = 0;
  static constexpr bool solves_equations = true;
  static constexpr bool takes_fixed_steps = false;

  std::string_view id, source;
  std::string_view advice = "";
  int order = BdfFormulas::highest_order;
  int embedded_order = BdfFormulas::highest_order - 1;
  std::array<Coefficient, BdfFormulas::highest_order + 1> kappa{};  // by order; [0] unused

  Theory theory() const {
    Theory theory;
    theory.blank_reason = "varies its order and step: no single stability function";
    return theory;
  }

  /// Values between the steps of a run are side steps of the extrapolation method that starts fixed-step
  /// BDFs, with more rows: as stable, and more accurate over one step.
  template <const auto& method, System P>
  using Stepper = ExtrapolationStepper<LinearlyImplicitTable<P, 8, 2>>;

  template <const auto& method, System P, class Observer>
  static RunReport drive(const P& system, const Control& control, double t0, double t1, typename P::State& y,
                         Observer&& observe) {
    if (const auto* adaptive = std::get_if<ErrorControl>(&control))
      return BdfDriver<P>(system, BdfFormulas{method.kappa}, *adaptive, y).run(t0, t1, y, observe);
    return chooses_its_own_steps(t0);
  }
};

}  // namespace odemark
