// Facts of multistep methods: order from the principal root, zero-stability, how fast steps may grow.
#include <algorithm>
#include <cmath>
#include <limits>

#include "integrators/facts_parts.hpp"
#include "integrators/linear_stability_parts.hpp"

namespace odemark::detail {

namespace {

bool is_zero(Coefficient x) { return std::abs(x) < 1e-15L; }

bool is_bdf(const Theory& t) {
  return !t.sigma.empty() && t.sigma.size() == t.rho.size() && !is_zero(t.sigma.back()) &&
         std::all_of(t.sigma.begin(), t.sigma.end() - 1, is_zero);
}

bool is_adams(const std::vector<Coefficient>& rho) {
  const auto inner = [](Coefficient x) { return is_zero(x); };
  return rho.size() >= 2 && is_zero(rho.back() + rho[rho.size() - 2]) &&
         std::all_of(rho.begin(), rho.end() - 2, inner);
}

bool palindrome(std::vector<Coefficient> p, std::size_t size, Coefficient sign) {
  p.resize(size, 0);
  for (std::size_t j = 0; j < size; ++j)
    if (!is_zero(p[j] - sign * p[size - 1 - j])) return false;
  return true;
}

/// Strong stability: explicit combinations of Euler steps (implicit ones: the old values alone may be
/// convex).
Coefficient ssp_of(const Theory& t) {
  Coefficient smallest = infinity;
  const Coefficient lead = t.rho.back();
  for (std::size_t j = 0; j + 1 < t.rho.size(); ++j) {
    const Coefficient a = -t.rho[j] / lead, b = j < t.sigma.size() ? t.sigma[j] / lead : 0;
    if (a < -1e-15L || b < -1e-15L) return 0;
    if (!is_zero(b)) smallest = std::min(smallest, a / b);
  }
  return t.sigma.size() == t.rho.size() && t.sigma.back() / lead < 0 ? 0 : smallest;
}

}  // namespace

/// The largest constant ratio of steps at which the variable-step formula keeps its roots but 1 inside the
/// unit circle (R. D. Grigorieff, Numer. Math. 42 (1983) 359-377).
Coefficient step_ratio_limit_of_bdf(std::size_t steps) {
  if (steps < 2) return infinity;
  const auto stable = [steps](Coefficient ratio) {
    std::vector<Coefficient> nodes{0}, rho(steps + 1);
    Coefficient step = 1;
    for (std::size_t j = 1; j <= steps; ++j, step /= ratio) nodes.push_back(nodes.back() - step);
    for (std::size_t j = 0; j <= steps; ++j) {  // l_j'(0) of the interpolating polynomial
      Coefficient weight = 0;
      if (j == 0) {
        for (std::size_t m = 1; m <= steps; ++m) weight += 1 / (nodes[0] - nodes[m]);
      } else {
        weight = 1 / (nodes[j] - nodes[0]);
        for (std::size_t m = 1; m <= steps; ++m)
          if (m != j) weight *= (nodes[0] - nodes[m]) / (nodes[j] - nodes[m]);
      }
      rho[steps - j] = weight;
    }
    std::vector<WideComplex> rest(steps);  // rho / (w - 1)
    Coefficient carried = 0;
    for (std::size_t k = steps; k >= 1; --k) carried += rho[k], rest[k - 1] = carried;
    for (const auto& w : polynomial_roots(rest))
      if (!(std::abs(w) < 1)) return false;
    return true;
  };
  if (!stable(1)) return 1;
  Coefficient low = 1, high = 8;
  for (int i = 0; i < 60; ++i) (stable((low + high) / 2) ? low : high) = (low + high) / 2;
  return low;
}

void add_multistep_facts(const Theory& theory, MethodFacts& facts) {
  const bool pece = !theory.characteristic.empty();
  Theory at_rest;
  at_rest.rho = pece ? theory.characteristic.front() : theory.rho;
  while (!at_rest.rho.empty() && at_rest.rho.back() == 0) at_rest.rho.pop_back();
  const auto root = principal_root(theory);
  facts.order = {root.order, "of the principal root"};
  facts.error_constant = {std::abs(root.error),
                          "C / sigma(1): the error of y' = lambda y over h^p lambda^(p+1)"};
  facts.stability = stability_facts(theory);
  facts.zero_stable = zero_stable(at_rest);
  const std::string stages = "a multistep method has no stages";
  facts.stages = facts.stage_order = Fact<int>::none(stages);
  facts.fsal = facts.stiffly_accurate = Fact<bool>::none(stages);
  facts.internal_amplification = Fact<Coefficient>::none(stages);
  const std::string one_step = "a notion of one-step methods";
  facts.algebraically_stable = facts.symplectic = Fact<bool>::none(one_step);
  if (is_adams(at_rest.rho))
    facts.step_ratio_limit = {infinity, "its roots but 1 are 0 at every ratio"};
  else if (!pece && is_bdf(theory))
    facts.step_ratio_limit = step_ratio_limit_of_bdf(theory.rho.size() - 1);
  else
    facts.step_ratio_limit = Fact<Coefficient>::none("no usual variable-step form");
  if (pece) {
    facts.evaluations_per_step = int(theory.characteristic.size()) - 1;
    facts.linear_solves_per_step = 0;
    facts.ssp_coefficient =
        Fact<Coefficient>::none("a notion of Runge-Kutta and of linear multistep methods");
    facts.symmetric = false;
    return;
  }
  const bool implicit = theory.sigma.size() == theory.rho.size() && !is_zero(theory.sigma.back());
  facts.ssp_coefficient = ssp_of(theory);
  facts.symmetric =
      palindrome(theory.rho, theory.rho.size(), -1) && palindrome(theory.sigma, theory.rho.size(), 1);
  if (implicit) {
    facts.evaluations_per_step = Fact<int>::none("depends on the iterations that solve the step");
    facts.linear_solves_per_step = {1, "in every Newton iteration"};
  } else {
    facts.evaluations_per_step = 1, facts.linear_solves_per_step = 0;
  }
}

}  // namespace odemark::detail
