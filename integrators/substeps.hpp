// Any one-step method with n equal substeps to a step: what engines call substepping.
#pragma once

#include "integrators/linear_stability.hpp"
#include "integrators/theory.hpp"

namespace odemark {

template <const auto& method, System P>
class SubstepsStepper;

/// A step of h is `count` steps of h / count of `base`, each started afresh. To make another:
///
///   #include "integrators/methods/rk4.hpp"
///   #include "integrators/substeps.hpp"
///   namespace odemark {
///   inline constexpr Substeps<rk4, 3> rk4_substeps3{.id = "rk4_substeps3", .source = rk4.source};
///   }
///
/// in integrators/methods/rk4_substeps3.hpp, and its id in integrators/catalogue.txt.
template <const auto& base, int count>
struct Substeps {
  static_assert(count > 1);
  static constexpr std::string_view kind_name = "substeps";
  static constexpr unsigned needs = KindOf<base>::needs;
  static constexpr int substeps = count;

  std::string_view id, source;
  int order = base.order;
  int embedded_order = 0;
  std::string_view note = [] {
    if constexpr (requires { base.note; }) return std::string_view(base.note);
    return std::string_view("");
  }();
  std::string_view advice = "";

  Theory theory() const { return theory_of_substeps(base.theory(), count); }

  template <const auto& method, System P>
  using Stepper = SubstepsStepper<method, P>;
  template <class P>
  using BaseStepper = StepperOf<base, P>;
};

template <const auto& method, System P>
class SubstepsStepper {
 public:
  using State = typename P::State;
  using Real = RealOf<State>;
  using Base = typename KindOf<method>::template BaseStepper<P>;
  static_assert(!HasHistory<Base>, "a method that keeps past steps gains nothing from being started afresh");

  SubstepsStepper(const P& system, const State& model) : base_(system, model), from_(model) {}

  void start() {}
  void accept() {}
  NewtonCounts newton_counts() const requires requires(const Base& b) { b.newton_counts(); }
  { return base_.newton_counts(); }

  StepStatus attempt(Real t, const State& y, Real h, State& next, State& error) {
    const Real part = h / Real(method.substeps);
    base_.start();
    from_ = y;
    for (int i = 0; i < method.substeps; ++i) {
      if (i > 0) std::swap(from_, next);
      const StepStatus status = base_.attempt(t + Real(i) * part, from_, part, next, error);
      if (status != StepStatus::ok) return status;
      base_.accept();
    }
    return StepStatus::ok;
  }

 private:
  Base base_;
  State from_;
};

}  // namespace odemark
