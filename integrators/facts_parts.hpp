// The parts that method_facts() is put together from.
#pragma once

#include "integrators/facts.hpp"

namespace odemark::detail {

constexpr bool is_one_step_function(const Theory& t) { return !t.numerator.empty(); }
bool takes_several_steps(const Theory& t);

/// b'(I - zA)^-1 of a tableau as R = P / Q with what order says of the coefficients put in exactly: for
/// explicit tableaux by powers of A, else by Faddeev and LeVerrier. `a` is A, for Rosenbrock alpha + gamma.
Theory stability_function(std::size_t stages, const std::vector<Coefficient>& a,
                          const std::vector<Coefficient>& b, int order);
/// alpha + gamma of a Rosenbrock tableau, else A.
std::vector<Coefficient> implicit_matrix(const Tableau& tableau);
bool is_explicit(const Tableau& tableau);
/// The formula that the estimate compares with, as `b`; f(t, y) is its first stage where it is none of the
/// method's.
Tableau embedded_tableau(const Tableau& tableau);

StabilityFacts stability_facts(const Theory& theory);
StabilityFacts no_stability_facts(const std::string& why);
void add_tableau_facts(const Theory& theory, int order, int embedded_order, MethodFacts& facts);
void add_multistep_facts(const Theory& theory, MethodFacts& facts);
void add_oscillator_facts(const Theory& theory, MethodFacts& facts);

/// ln |w(iy)| and arg w(iy) - y of the root w = 1 + z + ... that is the solution, from its series in z.
struct PrincipalRoot {
  Fact<PowerLaw> log_amplification, phase_error;
  int order = 0;          // largest q with w(z) = e^z + O(z^(q+1))
  Coefficient error = 0;  // the coefficient of z^(order+1) in ln w(z): minus the error constant over sigma(1)
};
PrincipalRoot principal_root(const Theory& theory);

Fact<Coefficient> ssp_coefficient(std::size_t stages, const std::vector<Coefficient>& a,
                                  const std::vector<Coefficient>& b);
Fact<Coefficient> internal_amplification(const Tableau& tableau, const Theory& function);
bool algebraically_stable(std::size_t stages, const std::vector<Coefficient>& a,
                          const std::vector<Coefficient>& b);
Coefficient step_ratio_limit_of_bdf(std::size_t steps);

/// Roots of the step-size recursion at the point z of the boundary, for each filter.
std::map<std::string, Coefficient> controller_radii(const Theory& main, const Theory& embedded, Coefficient z,
                                                    int control_order);

}  // namespace odemark::detail
