// Which methods are symplectic, symmetric or area-preserving, read off their theory.
#pragma once

#include <algorithm>
#include <cmath>

#include "integrators/linear_stability.hpp"
#include "tests/support/runs.hpp"

namespace odemark {

/// |R(iz)| = 1 for every z: numerator and denominator mirror each other.
inline bool mirrors(const Theory& theory) {
  if (theory.numerator.empty() || theory.numerator.size() != theory.denominator.size()) return false;
  for (std::size_t k = 0; k < theory.numerator.size(); ++k)
    if (std::abs(double(theory.numerator[k] - (k % 2 ? -1 : 1) * theory.denominator[k])) > 1e-15)
      return false;
  return true;
}

inline bool reads_the_same_backwards(const std::vector<SecondOrderMove>& moves) {
  using What = SecondOrderMove::What;
  // without a velocity in the force every kick is the same
  const auto is_drift = [](const SecondOrderMove& m) { return m.what == What::drift; };
  return !moves.empty() &&
         std::equal(moves.begin(), moves.end(), moves.rbegin(), [&](const auto& a, const auto& b) {
           return is_drift(a) == is_drift(b) && std::abs(double(a.weight - b.weight)) < 1e-15;
         });
}

/// Drifts and kicks are shears, whatever the velocity that the force does not look at; the force of the start
/// once more is none.
inline bool is_made_of_shears(const std::vector<SecondOrderMove>& moves) {
  return !moves.empty() && std::none_of(moves.begin(), moves.end(), [](const auto& m) {
    return m.what == SecondOrderMove::What::kick_start;
  });
}

/// b_i a_ij + b_j a_ji = b_i b_j (J. M. Sanz-Serna, BIT 28 (1988) 877-883).
inline bool has_symplectic_tableau(const Tableau& t) {
  for (std::size_t i = 0; i < t.stages; ++i)
    for (std::size_t j = 0; j < t.stages; ++j)
      if (std::abs(double(t.b[i] * t.a[i * t.stages + j] + t.b[j] * t.a[j * t.stages + i] -
                          t.b[i] * t.b[j])) > 1e-17)
        return false;
  return t.stages > 0;
}

/// A step of -h undoes a step of h on the undamped oscillator.
inline bool undoes_itself(const Theory& theory) {
  for (const Coefficient h : {0.125L, 0.5L, 1.0L, 1.75L}) {
    const auto there = second_order_matrix(theory, 1, 0, h), back = second_order_matrix(theory, 1, 0, -h);
    if (there.size() != 4) return false;
    for (std::size_t r = 0; r < 2; ++r)
      for (std::size_t c = 0; c < 2; ++c)
        if (std::abs(double(back[r] * there[2 * c] + back[2 + r] * there[2 * c + 1] - (r == c))) > 1e-15)
          return false;
  }
  return true;
}

inline bool is_symplectic(const AnyMethod& m) {
  // with no damping to treat apart, a kick and a drift are left
  return is_made_of_shears(m.theory().moves) || has_symplectic_tableau(m.theory().tableau) ||
         m.kind == "semi-implicit Euler, damping apart";
}
inline bool conserves_area(const AnyMethod& m) { return conserves_area(m.theory()) || mirrors(m.theory()); }
inline bool is_symmetric(const AnyMethod& m) {
  return mirrors(m.theory()) ||
         (is_made_of_shears(m.theory().moves) && reads_the_same_backwards(m.theory().moves)) ||
         (m.theory().second_order_step && undoes_itself(m.theory()));
}

inline bool is_one_step(const AnyMethod& m) {
  static const AnyProblem oscillator = suite_problem("oscillator");
  return m.takes_fixed_steps && !m.multistep && m.runs<double>().transition && can_run<double>(m, oscillator);
}

}  // namespace odemark
