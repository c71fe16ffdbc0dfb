// How large a step a method's coefficients allow on a linear problem: limits, later bands, growth. Theory
// only.
#pragma once

#include <string>

#include "integrators/eigenvalues.hpp"
#include "integrators/real_polynomial.hpp"
#include "integrators/theory.hpp"

namespace odemark {

/// y' = J y, as far as stability is concerned.
struct LinearProblem {
  std::vector<WideComplex> eigenvalues;  // 1/s
  Coefficient fastest_rate = 0;          // largest |eigenvalue|
  /// One degree of freedom written as x'' = -stiffness x - damping v: what second-order moves act on.
  bool second_order = false;
  Coefficient stiffness = 0, damping = 0;  // 1/s^2, 1/s

  bool grows() const;  // an eigenvalue lies right of the imaginary axis
};

/// `jacobian` is column-major; `second_order` says that the state is (x, v) with x' = v.
LinearProblem linear_problem(std::size_t size, const std::vector<Coefficient>& jacobian, bool second_order);

enum class Stability {
  limit,      // stable from 0 up to the limit, unstable just beyond it
  unstable,   // unstable for every dt, however small, up to the first band (if there is one)
  unlimited,  // stable for every dt
  unknown,    // see `reason`
};

struct StabilityLimit {
  Stability verdict = Stability::unknown;
  std::string reason;
  Coefficient limit = 0;  // dt, s
  Intervals later_bands;  // stable intervals of dt beyond the first instability; the last may be open
  std::vector<Coefficient>
      touches;  // dt where |R| = 1 is touched from below: on the boundary, never beyond it
};

/// Stable means: no eigenvalue of the step lies outside the unit circle. An eigenvalue 0 of the problem is a
/// quantity that the method keeps (R(0) = 1): it never limits dt. Whether an eigenvalue is defective is not
/// asked: it matters on the boundary only, and a limit is the boundary.
StabilityLimit stability_limit(const Theory& theory, const LinearProblem& problem);

/// ln of the spectral radius of one step; accurate where it is tiny. NaN where theory says nothing.
Coefficient growth_per_step(const Theory& theory, const LinearProblem& problem, Coefficient dt);

/// One step of dt on x'' = -stiffness x - damping v, column-major; empty where theory knows no such step.
std::vector<Coefficient> second_order_matrix(const Theory& theory, Coefficient stiffness, Coefficient damping,
                                             Coefficient dt);
/// Is the determinant of that step 1 without damping, whatever dt?
bool conserves_area(const Theory& theory);
/// Of a step that is `count` equal steps of a one-step method.
Theory theory_of_substeps(const Theory& base, int count);

/// |R(z)|; for multistep methods the largest root of rho(w) - z sigma(w), or of the characteristic
/// polynomial. Not for moves: they see no single z.
Coefficient amplification(const Theory& theory, WideComplex z);

/// The largest q with R(z) = e^z + O(z^(q+1)). What order says must vanish may be taken to be 0.
int linear_order(const Theory& theory);

/// All z for which a multistep method has the root e^(i angle): rho / sigma, or the two of a
/// predictor-corrector.
std::vector<WideComplex> root_locus(const Theory& theory, Coefficient angle);

}  // namespace odemark
