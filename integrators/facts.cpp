// Which facts a method has, by what its theory is given in.
#include "integrators/facts.hpp"

#include <algorithm>
#include <cmath>

#include "integrators/facts_parts.hpp"

namespace odemark {

namespace {

using Radii = std::map<std::string, Coefficient>;

Fact<Radii> controllers(const Theory& theory, const MethodFacts& facts, int embedded_order) {
  const Tableau& t = theory.tableau;
  if (embedded_order == 0 || t.b_embedded.empty()) return Fact<Radii>::none("no embedded pair");
  const auto& end = facts.stability.real_interval;
  if (!end || !std::isfinite(*end) || *end <= 0)
    return Fact<Radii>::none("stability does not limit its steps on the negative real axis");
  const Tableau e = detail::embedded_tableau(t);
  const int order = *facts.order, embedded = *facts.embedded_order;
  return detail::controller_radii(
      detail::stability_function(t.stages, detail::implicit_matrix(t), t.b, order),
      detail::stability_function(e.stages, detail::implicit_matrix(e), e.b, embedded), -*end,
      std::min(order, embedded) + 1);
}

/// The theory with the polynomials that its tableau really has: what order makes of them is exact.
Theory with_function(const Theory& theory, const MethodFacts& facts) {
  const Tableau& t = theory.tableau;
  if (t.stages == 0) return theory;
  return detail::stability_function(t.stages, detail::implicit_matrix(t), t.b, *facts.order);
}

void blank_tableau_facts(MethodFacts& f, const std::string& why) {
  f.stages = f.stage_order = f.evaluations_per_step = f.linear_solves_per_step = Fact<int>::none(why);
  f.fsal = f.stiffly_accurate = f.algebraically_stable = f.symplectic = f.symmetric = Fact<bool>::none(why);
  f.error_constant = f.ssp_coefficient = f.internal_amplification = Fact<Coefficient>::none(why);
}

/// Polynomials without a tableau (stabilised methods, Taylor series): what R alone tells.
void add_function_facts(const Theory& theory, MethodFacts& f) {
  blank_tableau_facts(f, "not given as a tableau");
  f.stability = detail::stability_facts(theory);
  const int linear = linear_order(theory);
  if (linear < *f.order) f.order = {linear, "of R: what it claims is more"};
  // R(z) R(-z) = 1 is needed for either
  const auto& law = f.stability.log_amplification;
  if (law && law.value) f.symplectic = f.symmetric = false;
}

/// On the free oscillator a step of order p errs by z^(p+1) in angle and amplitude, so what it does there
/// bounds its order. The claim stands where nothing contradicts it.
void check_order_on_oscillator(MethodFacts& f) {
  int order = *f.order;
  for (const auto* law : {&f.stability.log_amplification, &f.stability.phase_error})
    if (*law) order = std::min(order, (*law)->power - 1);
  if (order < *f.order)
    f.order = {order, "of what it does to a free oscillation"};
  else
    f.order.reason = "claimed, and not contradicted by what it does to a free oscillation";
}

/// Special Nystrom trees decide on x'' = a(t, x), words in drift and kick on the sum of any two flows.
void add_proof(const ProvedOrders& proved, int claimed, MethodFacts& f) {
  const std::string trees = "proved by special Nystrom trees, to rounding";
  f.order = {proved.order, trees};
  if (proved.for_any_split >= std::max(1, std::min(claimed, proved.order)))
    f.order.reason += "; by words of drifts and kicks, for any two flows";
  else if (proved.for_any_split > 0)
    f.order.reason +=
        "; " + std::to_string(proved.for_any_split) + " where the kinetic energy is not quadratic";
  if (f.embedded_order) f.embedded_order = {proved.embedded_order, trees};
}

}  // namespace

MethodFacts method_facts(const Theory& theory, int order, int embedded_order) {
  MethodFacts f;
  const std::string no_estimate = "no embedded formula";
  blank_tableau_facts(
      f, theory.blank_reason.empty() ? "not given as a tableau" : std::string(theory.blank_reason));
  f.order = {order, "claimed"};
  f.embedded_order = embedded_order > 0 ? Fact<int>{embedded_order, "claimed"} : Fact<int>::none(no_estimate);
  f.embedded_error_constant = Fact<Coefficient>::none(no_estimate);
  f.embedded =
      detail::no_stability_facts(embedded_order > 0 ? "the estimate is not given as a tableau" : no_estimate);
  if (embedded_order > 0)
    f.embedded_error_constant = Fact<Coefficient>::none("the estimate is not given as a tableau");
  f.zero_stable = {true, "a one-step method"};
  f.step_ratio_limit = Fact<Coefficient>::none("a one-step method");
  if (theory.tableau.stages > 0) {
    detail::add_tableau_facts(theory, order, embedded_order, f);
  } else if (detail::takes_several_steps(theory)) {
    detail::add_multistep_facts(theory, f);
  } else if (detail::is_one_step_function(theory)) {
    add_function_facts(theory, f);
  } else {
    f.stability = detail::stability_facts(theory);
  }
  if (theory.most_stages > 0)
    f.internal_amplification = {
        theory.internal_amplification,
        "of a step with " + std::to_string(theory.most_stages) + " stages, as many as double allows"};
  detail::add_oscillator_facts(with_function(theory, f), f);
  if (theory.proof)
    add_proof(theory.proof(), order, f);
  else if (!theory.moves.empty())
    check_order_on_oscillator(f);
  f.controller_spectral_radius = controllers(theory, f, embedded_order);
  return f;
}

}  // namespace odemark
