#include "integrators/theory.hpp"

#include <cmath>

namespace odemark {

namespace {

using Polynomial = std::vector<Coefficient>;

/// det(I - z M) = sum_k q_k z^k with q_k the coefficients of the characteristic polynomial of M.
Polynomial determinant(const std::vector<Coefficient>& m, std::size_t n) {
  Polynomial q{1};
  std::vector<Coefficient> power(n * n, 0), product(n * n);
  for (std::size_t i = 0; i < n; ++i) power[i * n + i] = 1;
  for (std::size_t k = 1; k <= n; ++k) {
    Coefficient trace = 0;
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < n; ++j) {
        product[i * n + j] = 0;
        for (std::size_t l = 0; l < n; ++l) product[i * n + j] += m[i * n + l] * power[l * n + j];
      }
      trace += product[i * n + i];
    }
    q.push_back(-trace / Coefficient(k));
    power = product;
    for (std::size_t i = 0; i < n; ++i) power[i * n + i] += q.back();
  }
  // powers beyond the degree are rounding noise of the recursion, not coefficients
  while (q.size() > 1 && std::abs(q.back()) < 1e-16L) q.pop_back();
  return q;
}

bool is_explicit(const Tableau& t) {
  for (std::size_t i = 0; i < t.stages; ++i)
    for (std::size_t j = i; j < t.stages; ++j)
      if (t.a[i * t.stages + j] != 0) return false;
  return true;
}

/// R(z) = 1 + sum_k b' A^(k-1) 1 z^k of an explicit method: a determinant would lose the digits that
/// coefficients of hundreds take. What is below the rounding of its own terms is 0.
Polynomial explicit_polynomial(const Tableau& t) {
  const std::size_t n = t.stages;
  Polynomial polynomial{1};
  std::vector<Coefficient> power(n, 1), size(n, 1);
  for (std::size_t k = 1; k <= n; ++k) {
    Coefficient sum = 0, scale = 0;
    std::vector<Coefficient> next(n, 0), next_size(n, 0);
    for (std::size_t i = 0; i < n; ++i) {
      sum += t.b[i] * power[i], scale += std::abs(t.b[i]) * size[i];
      for (std::size_t j = 0; j < i; ++j) {
        next[i] += t.a[i * n + j] * power[j];
        next_size[i] += std::abs(t.a[i * n + j]) * size[j];
      }
    }
    polynomial.push_back(std::abs(sum) > 1e-18L * Coefficient(n) * scale ? sum : 0);
    power = next, size = next_size;
  }
  while (polynomial.back() == 0) polynomial.pop_back();
  return polynomial;
}

/// The real eigenvalue of a matrix that has only one and it is positive: 1 / x for the root x of det(I - x
/// A), by bisection.
Coefficient real_eigenvalue(const Polynomial& determinant) {
  Coefficient low = 0, high = 64;
  for (int i = 0; i < 128; ++i) {
    const Coefficient middle = (low + high) / 2;
    Coefficient value = 0;
    for (std::size_t k = determinant.size(); k-- > 0;) value = value * middle + determinant[k];
    (value > 0 ? low : high) = middle;
  }
  return 1 / low;
}

}  // namespace

Coefficient sum_of_magnitudes(std::span<const Coefficient> weights) {
  Coefficient sum = 0;
  for (const Coefficient w : weights) sum += std::abs(w);
  return sum;
}

std::vector<Coefficient> as_data(std::span<const Coefficient> row) { return {row.begin(), row.end()}; }

Theory runge_kutta_theory(Tableau tableau) {
  Theory theory;
  const std::size_t n = tableau.stages;
  if (is_explicit(tableau)) {
    theory.numerator = explicit_polynomial(tableau);
    theory.denominator = {1};
  } else {
    std::vector<Coefficient> shifted = tableau.a;
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j) shifted[i * n + j] -= tableau.b[j];
    theory.numerator = determinant(shifted, n);
    theory.denominator = determinant(tableau.a, n);
  }
  theory.tableau = std::move(tableau);
  return theory;
}

void compare_with_start(Theory& theory) {
  Tableau& t = theory.tableau;
  const Coefficient gamma = real_eigenvalue(theory.denominator);
  theory.estimate_filter = t.embedded_start = gamma;
  std::vector<Coefficient> nodes(t.stages, 0);
  for (std::size_t i = 0; i < t.stages; ++i)
    for (std::size_t j = 0; j < t.stages; ++j) nodes[i] += t.a[i * t.stages + j];
  for (std::size_t i = 0; i < t.stages; ++i) {
    Coefficient at_start = 1;
    for (std::size_t m = 0; m < t.stages; ++m)
      if (m != i) at_start *= -nodes[m] / (nodes[i] - nodes[m]);
    t.b_embedded.push_back(t.b[i] - gamma * at_start);
  }
}

Theory nystrom_theory(NystromTableau t) {
  const std::size_t n = t.stages;
  const auto combined = [n](Coefficient constant, const Coefficient* weights,
                            const std::vector<Polynomial>& of) {
    Polynomial sum(n + 1, 0);
    sum[0] = constant;
    for (std::size_t j = 0; j < of.size(); ++j)
      for (std::size_t k = 0; k < n; ++k) sum[k + 1] -= weights[j] * of[j][k];
    return sum;
  };
  std::vector<Polynomial> p, r;
  for (std::size_t i = 0; i < n; ++i) {
    const Coefficient* row = t.a.data() + i * n;
    auto next_p = combined(1, row, p), next_r = combined(t.c[i], row, r);
    p.push_back(std::move(next_p)), r.push_back(std::move(next_r));
  }
  Theory theory;
  theory.oscillator = {combined(1, t.b_position.data(), p), combined(1, t.b_position.data(), r),
                       combined(0, t.b_velocity.data(), p), combined(1, t.b_velocity.data(), r)};
  theory.nystrom = std::move(t);
  return theory;
}

}  // namespace odemark
