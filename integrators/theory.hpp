// What a method does to a linear problem, derived from the same coefficients that step.
#pragma once

#include <complex>
#include <functional>
#include <span>
#include <vector>

#include "integrators/stepper.hpp"

namespace odemark {

/// One instruction of a second-order step on x'' = a(x, v), in units of h; (x_n, v_n) is the start of the
/// step.
struct SecondOrderMove {
  enum class What {
    drift,           // x += weight h v
    kick,            // v += weight h a(x, v): the velocity is the current one
    kick_start,      // v += weight h a(x_n, v_n): the force of the start once more
    kick_old,        // v += weight h a(x, v_n): the velocity at the start of the step
    kick_predicted,  // v += weight h a(x, v_n + h a(x_n, v_n))
    kick_implicit,   // v = v + weight h a(x, v_new)
  };
  What what;
  Coefficient weight;
};

/// One step of h on x'' = -stiffness x - damping v as a square matrix, column-major: on (x, v), or on (x, v,
/// a) where the method carries an acceleration of its own along.
using SecondOrderStep =
    std::function<std::vector<Coefficient>(Coefficient stiffness, Coefficient damping, Coefficient h)>;

/// The coefficients of a one-step method as plain data, row by row; `stages` 0 where there are none.
struct Tableau {
  std::size_t stages = 0;
  std::vector<Coefficient> a, b, b_embedded;  // b_embedded empty: no error estimate
  std::vector<Coefficient> gamma;             // Rosenbrock: Gamma with its diagonal, a is alpha; else empty
  Coefficient embedded_start = 0;  // weight of f(t, y) in the embedded formula, where it is no stage
};

/// The same for Nystrom methods: `a` row by row; positions and velocities have weights of their own.
struct NystromTableau {
  std::size_t stages = 0;
  std::vector<Coefficient> c, a, b_position, b_velocity, b_position_embedded, b_velocity_embedded;
};

/// One step on x'' = -stiffness x as a matrix on (x, h v): its entries are polynomials in h^2 stiffness,
/// ascending powers; empty where a method does something else.
struct OscillatorMatrix {
  std::vector<Coefficient> xx, xv, vx, vv;
};

/// Orders that hold exactly: every condition up to there, and not every one beyond.
struct ProvedOrders {
  int order = 0, embedded_order = 0;
  int for_any_split = 0;  // of splittings: where the kinetic energy is not quadratic; 0: no splitting
};

/// Exactly one of the members down to `exact_on_linear_part` is filled, or `blank_reason`; which one says how
/// the method acts on y' = lambda y.
struct Theory {
  std::vector<Coefficient> numerator, denominator;  // R(z) = numerator / denominator, ascending powers
  std::vector<Coefficient> rho, sigma;              // multistep: rho(w) - z sigma(w), ascending powers
  /// Multistep beyond rho - z sigma (PECE): the coefficient of z^k w^j is characteristic[k][j].
  std::vector<std::vector<Coefficient>> characteristic;
  std::vector<SecondOrderMove> moves;  // acts on (x, v) as a 2x2 matrix
  OscillatorMatrix oscillator;         // Nystrom methods: the same where there is no damping
  SecondOrderStep second_order_step;   // the same where its entries are no polynomials in h
  bool exact_on_linear_part = false;   // exponential methods: R = exp(h L)
  /// What a step makes of a rounding in each of the values that it adds up: the sum of the magnitudes of
  /// their weights, where those are known, and at least 1.
  Coefficient rounding_amplification = 1;
  Tableau tableau;                  // what numerator and denominator come from, where they come from one
  Coefficient estimate_filter = 0;  // gamma: the estimate is the gap of the two formulas over 1 - gamma z
  NystromTableau nystrom;           // what oscillator comes from
  /// What trees or words prove of the coefficients, where `moves` or `oscillator` are all that is left of
  /// them.
  std::function<ProvedOrders()> proof;
  /// Of stabilised methods with as many stages as double allows: what roundings within a step become.
  Coefficient internal_amplification = 0;
  std::size_t most_stages = 0;
  std::string_view blank_reason = "";  // why nothing can be said, where nothing can
};

/// Of weights that sum to 1: how much more a rounding in what they weigh counts than in their sum.
Coefficient sum_of_magnitudes(std::span<const Coefficient> weights);

/// A row, or the rows of a square one after the other, as data of run-time size.
std::vector<Coefficient> as_data(std::span<const Coefficient> row);
template <std::size_t S>
std::vector<Coefficient> as_data(const std::array<std::array<Coefficient, S>, S>& rows) {
  std::array<Coefficient, S * S> all;
  for (std::size_t i = 0; i < S * S; ++i) all[i] = rows[i / S][i % S];
  return as_data(std::span<const Coefficient>(all));
}

/// R(z) = det(I - zA + z 1 b') / det(I - zA) (Hairer & Wanner, Solving ODEs II, IV.3), both by the
/// Faddeev-LeVerrier recursion; b' A^k 1 summed as it stands where A is strictly lower triangular. The
/// tableau is kept.
Theory runge_kutta_theory(Tableau tableau);
template <std::size_t S>
Theory runge_kutta_theory(const std::array<std::array<Coefficient, S>, S>& a,
                          const std::array<Coefficient, S>& b,
                          const std::array<Coefficient, S>* b_embedded = nullptr) {
  Tableau tableau{
      .stages = S, .a = as_data(a), .b = as_data(b), .b_embedded{}, .gamma{}, .embedded_start = 0};
  if (b_embedded) tableau.b_embedded = as_data(*b_embedded);
  return runge_kutta_theory(std::move(tableau));
}

/// The estimate of a collocation method, gamma h (f(t, y) - sum_i l_i(0) f(Y_i)) / (1 - gamma z) with l_i the
/// Lagrange polynomials of the nodes and gamma the only real eigenvalue of A (Hairer & Wanner, Solving ODEs
/// II, IV.8, eq. 8.19-8.20): a gap of weights like any other.
void compare_with_start(Theory& theory);

/// Stage positions on the oscillator are x p_i + (h v) r_i with polynomials in q = h^2 stiffness: p_i = 1 - q
/// sum_j a_ij p_j, r_i = c_i - q sum_j a_ij r_j. The tableau is kept.
Theory nystrom_theory(NystromTableau tableau);

}  // namespace odemark
