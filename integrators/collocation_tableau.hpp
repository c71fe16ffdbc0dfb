// Runge-Kutta coefficients from nodes, at compile time, and the order that simplifying assumptions prove.
#pragma once

#include "integrators/stepper.hpp"

namespace odemark {

template <std::size_t S>
using StageVector = std::array<Coefficient, S>;
template <std::size_t S>
using StageMatrix = std::array<StageVector<S>, S>;

/// The integral from 0 to `end` of the Lagrange polynomial that is 1 at c[j] and 0 at the other nodes: four
/// Gauss points, so exact up to eight nodes, and without the cancellation of a Vandermonde system.
template <std::size_t S>
constexpr Coefficient lagrange_integral(const StageVector<S>& c, std::size_t j, Coefficient end) {
  static_assert(S <= 8);
  constexpr Coefficient inner = 0.339981043584856264802665759103244687L,
                        outer = 0.861136311594052575223946488892809505L,
                        inner_weight = 0.652145154862546142626936050778000593L,
                        outer_weight = 0.347854845137453857373063949221999407L;
  Coefficient sum = 0;
  for (const auto& [x, weight] : {std::pair{-outer, outer_weight},
                                  {-inner, inner_weight},
                                  {inner, inner_weight},
                                  {outer, outer_weight}}) {
    const Coefficient at = end * (1 + x) / 2;
    Coefficient value = weight;
    for (std::size_t m = 0; m < S; ++m)
      if (m != j) value *= (at - c[m]) / (c[j] - c[m]);
    sum += value;
  }
  return sum * end / 2;
}

/// The collocation method of these nodes (E. Hairer, S. P. Norsett, G. Wanner, Solving ODEs I, II.7, theorem
/// 7.7): a_ij is the integral of the j-th Lagrange polynomial to c_i.
template <std::size_t S>
constexpr StageMatrix<S> collocation_matrix(const StageVector<S>& c) {
  StageMatrix<S> a{};
  for (std::size_t i = 0; i < S; ++i)
    for (std::size_t j = 0; j < S; ++j) a[i][j] = lagrange_integral<S>(c, j, c[i]);
  return a;
}
template <std::size_t S>
constexpr StageVector<S> quadrature_weights(const StageVector<S>& c) {
  StageVector<S> b{};
  for (std::size_t j = 0; j < S; ++j) b[j] = lagrange_integral<S>(c, j, 1);
  return b;
}

/// How far the simplifying assumptions hold: quadrature B(p), stages C(eta), and D(zeta).
struct SimplifyingAssumptions {
  int quadrature = 0, stage = 0, transposed = 0;

  /// The order that follows (J. C. Butcher, Math. Comp. 18 (1964) 50-64, theorem 7), exact because B(p + 1)
  /// is necessary for order p + 1; 0 where they do not reach as far as the quadrature.
  constexpr int proved_order() const {
    return quadrature <= stage + transposed + 1 && quadrature <= 2 * stage + 2 ? quadrature : 0;
  }
};

template <std::size_t S>
constexpr SimplifyingAssumptions simplifying_assumptions(const StageMatrix<S>& a, const StageVector<S>& b) {
  const auto vanishes = [](Coefficient x) { return x < 4e-17L && x > -4e-17L; };
  StageVector<S> c{}, power{};
  for (std::size_t i = 0; i < S; ++i) {
    power[i] = 1;
    for (std::size_t j = 0; j < S; ++j) c[i] += a[i][j];
  }
  SimplifyingAssumptions found;
  bool quadrature = true, stage = true, transposed = true;
  for (int k = 1; k <= 2 * int(S) + 1; ++k) {  // power[i] = c_i^(k-1)
    Coefficient sum = -1.0L / k;
    for (std::size_t i = 0; i < S; ++i) sum += b[i] * power[i];
    quadrature = quadrature && vanishes(sum);
    for (std::size_t i = 0; i < S; ++i) {
      Coefficient row = -power[i] * c[i] / k, column = -b[i] * (1 - power[i] * c[i]) / k;
      for (std::size_t j = 0; j < S; ++j) row += a[i][j] * power[j], column += b[j] * power[j] * a[j][i];
      stage = stage && vanishes(row), transposed = transposed && vanishes(column);
    }
    found.quadrature += quadrature, found.stage += stage, found.transposed += transposed;
    for (std::size_t i = 0; i < S; ++i) power[i] *= c[i];
  }
  return found;
}

}  // namespace odemark
