// What the stability tests share: methods and problems by name, spectra, theories.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <string>

#include "integrators/any_method.hpp"
#include "integrators/linear_stability.hpp"
#include "reference/any_problem.hpp"

namespace odemark {

inline const AnyMethod& method(std::string_view id) {
  for (const auto& m : suite_methods())
    if (m.id == id) return m;
  throw std::invalid_argument("no method " + std::string(id));
}
inline AnyProblem problem(std::string_view id, const std::string& settings = "") {
  return find_problem(suite_families(), id, settings);
}
inline AnyProblem damped(double zeta) { return problem("damped_spring", "zeta=" + std::to_string(zeta)); }

/// One complex pair or, on the negative real axis, one rate.
inline LinearProblem ray(Coefficient re, Coefficient im) {
  LinearProblem out;
  out.eigenvalues = {{re, im}};
  out.fastest_rate = std::hypot(re, im);
  return out;
}
inline LinearProblem spring(Coefficient zeta) { return linear_problem(2, {0, -1, 1, -2 * zeta}, true); }
inline LinearProblem real_axis() { return ray(-1, 0); }
inline LinearProblem imaginary_axis() { return ray(0, 1); }

inline double limit_of(const Theory& theory, const LinearProblem& p) {
  const auto found = stability_limit(theory, p);
  EXPECT_EQ(found.verdict, Stability::limit) << found.reason;
  return double(found.limit);
}
inline double limit_of(std::string_view id, const LinearProblem& p) {
  return limit_of(method(id).theory(), p);
}
inline Stability verdict_of(std::string_view id, const LinearProblem& p) {
  return stability_limit(method(id).theory(), p).verdict;
}

inline Theory polynomial(std::vector<Coefficient> numerator) {
  Theory theory;
  theory.numerator = std::move(numerator), theory.denominator = {1};
  return theory;
}
inline Theory multistep(std::vector<Coefficient> rho, std::vector<Coefficient> sigma) {
  Theory theory;
  theory.rho = std::move(rho), theory.sigma = std::move(sigma);
  return theory;
}
inline Theory of_moves(std::vector<SecondOrderMove> moves) {
  Theory theory;
  theory.moves = std::move(moves);
  return theory;
}
using What = SecondOrderMove::What;

}  // namespace odemark
