// What a method does to a linear problem, derived from the same coefficients that step.
#pragma once

#include <complex>
#include <functional>
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
  std::string_view blank_reason = "";  // why nothing can be said, where nothing can
};

/// Of weights that sum to 1: how much more a rounding in what they weigh counts than in their sum.
template <class Weights>
Coefficient sum_of_magnitudes(const Weights& weights) {
  Coefficient sum = 0;
  for (const Coefficient w : weights) sum += w < 0 ? -w : w;
  return sum;
}

/// R(z) = det(I - zA + z 1 b') / det(I - zA) (Hairer & Wanner, Solving ODEs II, IV.3), both by the
/// Faddeev-LeVerrier recursion. For strictly lower triangular A the denominator is 1.
template <std::size_t S>
Theory runge_kutta_theory(const std::array<std::array<Coefficient, S>, S>& a,
                          const std::array<Coefficient, S>& b,
                          const std::array<Coefficient, S>* b_embedded = nullptr) {
  using Matrix = std::array<std::array<Coefficient, S>, S>;
  // det(I - z M) = sum_k q_k z^k with q_k the coefficients of the characteristic polynomial of M
  const auto determinant = [](const Matrix& m) {
    std::vector<Coefficient> q{1};
    Matrix power{};
    for (std::size_t i = 0; i < S; ++i) power[i][i] = 1;
    for (std::size_t k = 1; k <= S; ++k) {
      Matrix product{};
      for (std::size_t i = 0; i < S; ++i)
        for (std::size_t j = 0; j < S; ++j)
          for (std::size_t l = 0; l < S; ++l) product[i][j] += m[i][l] * power[l][j];
      Coefficient trace = 0;
      for (std::size_t i = 0; i < S; ++i) trace += product[i][i];
      q.push_back(-trace / Coefficient(k));
      power = product;
      for (std::size_t i = 0; i < S; ++i) power[i][i] += q.back();
    }
    return q;
  };
  Matrix shifted = a;
  for (std::size_t i = 0; i < S; ++i)
    for (std::size_t j = 0; j < S; ++j) shifted[i][j] -= b[j];
  Theory theory;
  theory.numerator = determinant(shifted);
  theory.denominator = determinant(a);
  theory.tableau.stages = S;
  for (const auto& row : a) theory.tableau.a.insert(theory.tableau.a.end(), row.begin(), row.end());
  theory.tableau.b.assign(b.begin(), b.end());
  if (b_embedded) theory.tableau.b_embedded.assign(b_embedded->begin(), b_embedded->end());
  // powers beyond the degree are rounding noise of the recursion, not coefficients
  for (auto* polynomial : {&theory.numerator, &theory.denominator})
    while (polynomial->size() > 1 && polynomial->back() < 1e-16L && polynomial->back() > -1e-16L)
      polynomial->pop_back();
  return theory;
}

/// Stage positions on the oscillator are x p_i + (h v) r_i with polynomials in q = h^2 stiffness: p_i = 1 - q
/// sum_j a_ij p_j, r_i = c_i - q sum_j a_ij r_j.
template <class Method>
Theory nystrom_theory(const Method& m) {
  constexpr std::size_t S = Method::stages;
  using Polynomial = std::vector<Coefficient>;
  const auto combined = [&](Coefficient constant, const auto& weights, const std::vector<Polynomial>& of) {
    Polynomial sum(S + 1, 0);
    sum[0] = constant;
    for (std::size_t j = 0; j < of.size(); ++j)
      for (std::size_t k = 0; k < S; ++k) sum[k + 1] -= weights[j] * of[j][k];
    return sum;
  };
  std::vector<Polynomial> p, r;
  for (std::size_t i = 0; i < S; ++i) {
    auto next_p = combined(1, m.a[i], p), next_r = combined(m.c[i], m.a[i], r);
    p.push_back(std::move(next_p)), r.push_back(std::move(next_r));
  }
  Theory theory;
  theory.oscillator = {combined(1, m.b_position, p), combined(1, m.b_position, r),
                       combined(0, m.b_velocity, p), combined(1, m.b_velocity, r)};
  auto& t = theory.nystrom;
  t.stages = S;
  for (const auto& row : m.a) t.a.insert(t.a.end(), row.begin(), row.end());
  t.c.assign(m.c.begin(), m.c.end());
  t.b_position.assign(m.b_position.begin(), m.b_position.end());
  t.b_velocity.assign(m.b_velocity.begin(), m.b_velocity.end());
  if (m.embedded_order > 0) {
    t.b_position_embedded.assign(m.b_position_embedded.begin(), m.b_position_embedded.end());
    t.b_velocity_embedded.assign(m.b_velocity_embedded.begin(), m.b_velocity_embedded.end());
  }
  return theory;
}

}  // namespace odemark
