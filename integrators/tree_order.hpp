// Orders of Runge-Kutta and Rosenbrock tableaux by all rooted trees, memoised; proved in integers where the
// coefficients are fractions.
#pragma once

#include "integrators/theory.hpp"

namespace odemark {

struct TreeOrder {
  int order = 0;  // every condition up to it holds, one of the next order does not
  bool exact =
      false;  // shown in integers, for fractions that round to the coefficients; else to their rounding
  Coefficient worst_residual = 0;  // up to `order`, in roundings of what was summed
  /// 2-norm over the trees of the next order of (Phi(t) - 1 / gamma(t)) / sigma(t).
  Coefficient principal_error_norm = 0;
};

/// Conditions b . Phi(t) = 1 / gamma(t) (E. Hairer, S. P. Norsett, G. Wanner, Solving ODEs I, II.2). For a
/// Rosenbrock tableau (gamma not empty) a node with one child takes alpha + gamma on its edge, others alpha
/// (E. Hairer, G. Wanner, Solving ODEs II, IV.7). Looks up to `highest`.
TreeOrder tree_order(const Tableau& tableau, const std::vector<Coefficient>& b, int highest = 12);

/// Number of rooted trees with `order` nodes, from the same enumeration.
std::size_t count_trees(int order);

}  // namespace odemark
