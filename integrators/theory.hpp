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

/// Exactly one of the members down to `exact_on_linear_part` is filled, or `blank_reason`; which one says how
/// the method acts on y' = lambda y.
struct Theory {
  std::vector<Coefficient> numerator, denominator;  // R(z) = numerator / denominator, ascending powers
  std::vector<Coefficient> rho, sigma;              // multistep: rho(w) - z sigma(w), ascending powers
  /// Multistep beyond rho - z sigma (PECE): the coefficient of z^k w^j is characteristic[k][j].
  std::vector<std::vector<Coefficient>> characteristic;
  std::vector<SecondOrderMove> moves;      // acts on (x, v) as a 2x2 matrix
  OscillatorMatrix oscillator;             // Nystrom methods: the same where there is no damping
  SecondOrderStep second_order_step;       // the same where its entries are no polynomials in h
  bool exact_on_linear_part = false;       // exponential methods: R = exp(h L)
  Coefficient rounding_amplification = 1;  // of a step's own rounding: where values of large weight cancel
  Tableau tableau;                     // what numerator and denominator come from, where they come from one
  NystromTableau nystrom;              // what oscillator comes from
  std::string_view blank_reason = "";  // why nothing can be said, where nothing can
};

/// A row, or the rows of a square one after the other, as data of run-time size.
std::vector<Coefficient> as_data(std::span<const Coefficient> row);
template <std::size_t S>
std::vector<Coefficient> as_data(const std::array<std::array<Coefficient, S>, S>& rows) {
  std::array<Coefficient, S * S> all;
  for (std::size_t i = 0; i < S * S; ++i) all[i] = rows[i / S][i % S];
  return as_data(std::span<const Coefficient>(all));
}

/// What weights that cancel make of the rounding of what they weigh; ordinary ones count as 1.
inline Coefficient cancellation(Coefficient sum_of_magnitudes) {
  return sum_of_magnitudes > 10 ? sum_of_magnitudes : 1;
}

/// R(z) = det(I - zA + z 1 b') / det(I - zA) (Hairer & Wanner, Solving ODEs II, IV.3), both by the
/// Faddeev-LeVerrier recursion; b' A^k 1 summed as it stands where A is strictly lower triangular. The
/// tableau is kept.
Theory runge_kutta_theory(Tableau tableau);
template <std::size_t S>
Theory runge_kutta_theory(const std::array<std::array<Coefficient, S>, S>& a,
                          const std::array<Coefficient, S>& b,
                          const std::array<Coefficient, S>* b_embedded = nullptr) {
  Tableau tableau{.stages = S, .a = as_data(a), .b = as_data(b), .b_embedded{}, .gamma{}};
  if (b_embedded) tableau.b_embedded = as_data(*b_embedded);
  return runge_kutta_theory(std::move(tableau));
}

/// Stage positions on the oscillator are x p_i + (h v) r_i with polynomials in q = h^2 stiffness: p_i = 1 - q
/// sum_j a_ij p_j, r_i = c_i - q sum_j a_ij r_j. The tableau is kept.
Theory nystrom_theory(NystromTableau tableau);

}  // namespace odemark
