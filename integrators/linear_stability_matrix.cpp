// Second-order steps whose entries are no polynomials in dt (exponentials, clamped factors, quotients):
// numbers instead of algebra, and the edges of stability by bisection.
#include <algorithm>
#include <cmath>
#include <limits>

#include "integrators/linear_stability_parts.hpp"

namespace odemark {

namespace {

std::vector<Coefficient> product(const std::vector<Coefficient>& a, const std::vector<Coefficient>& b) {
  const auto n = static_cast<std::size_t>(std::lround(std::sqrt(double(a.size()))));
  std::vector<Coefficient> out(n * n, 0);
  for (std::size_t c = 0; c < n; ++c)
    for (std::size_t k = 0; k < n; ++k)
      for (std::size_t r = 0; r < n; ++r) out[c * n + r] += a[k * n + r] * b[c * n + k];
  return out;
}

/// The coefficients of p(z / count), to the power `count`.
std::vector<Coefficient> substepped(const std::vector<Coefficient>& p, int count) {
  std::vector<Coefficient> part = p, out{1};
  Coefficient scale = 1;
  for (Coefficient& c : part) c *= scale, scale /= Coefficient(count);
  for (int i = 0; i < count; ++i) {
    std::vector<Coefficient> next(out.size() + part.size() - 1, 0);
    for (std::size_t j = 0; j < out.size(); ++j)
      for (std::size_t k = 0; k < part.size(); ++k) next[j + k] += out[j] * part[k];
    out = next;
  }
  return out;
}

bool only_drifts_and_kicks(const std::vector<SecondOrderMove>& moves) {
  return std::all_of(moves.begin(), moves.end(), [](const SecondOrderMove& m) {
    return m.what == SecondOrderMove::What::drift || m.what == SecondOrderMove::What::kick;
  });
}

}  // namespace

std::vector<Coefficient> second_order_matrix(const Theory& theory, Coefficient stiffness, Coefficient damping,
                                             Coefficient dt) {
  if (theory.second_order_step) return theory.second_order_step(stiffness, damping, dt);
  return detail::is_second_order(theory) ? detail::polynomial_matrix(theory, stiffness, damping, dt)
                                         : std::vector<Coefficient>{};
}

bool conserves_area(const Theory& theory) {
  for (const Coefficient h : {0.125L, 0.5L, 1.0L, 1.75L}) {
    const auto m = second_order_matrix(theory, 1, 0, h);
    if (m.size() != 4 || !(std::abs(m[0] * m[3] - m[1] * m[2] - 1) < 32 * detail::spacing)) return false;
  }
  return true;
}

Theory theory_of_substeps(const Theory& base, int count) {
  Theory theory;
  theory.blank_reason = base.blank_reason;
  theory.exact_on_linear_part = base.exact_on_linear_part;
  if (!base.numerator.empty()) {
    theory.numerator = substepped(base.numerator, count);
    theory.denominator = substepped(base.denominator, count);
  } else if (!base.moves.empty() && only_drifts_and_kicks(base.moves)) {
    for (int i = 0; i < count; ++i)
      for (SecondOrderMove move : base.moves) {
        move.weight /= Coefficient(count);
        theory.moves.push_back(move);
      }
  } else if (detail::is_second_order(base)) {
    theory.second_order_step = [base, count](Coefficient stiffness, Coefficient damping, Coefficient h) {
      const auto part = second_order_matrix(base, stiffness, damping, h / Coefficient(count));
      auto whole = part;
      for (int i = 1; i < count; ++i) whole = product(part, whole);
      return whole;
    };
  }
  return theory;
}

namespace detail {

Coefficient matrix_log_radius(const std::vector<Coefficient>& m) {
  Coefficient largest = 0;
  if (m.size() == 4) {
    // from half the trace and the determinant, so that a pair that meets on the circle costs no digits
    const Coefficient half = (m[0] + m[3]) / 2, determinant = m[0] * m[3] - m[1] * m[2];
    const Coefficient apart = (m[0] - m[3]) / 2, square = apart * apart + m[1] * m[2];
    if (square <= 4 * detail::spacing * (apart * apart + std::abs(m[1] * m[2])))
      return std::log(std::abs(determinant)) / 2;
    largest = std::abs(half) + std::sqrt(square);
  } else {
    const auto n = static_cast<std::size_t>(std::lround(std::sqrt(double(m.size()))));
    for (const WideComplex& root : eigenvalues(n, m)) largest = std::max(largest, std::abs(root));
  }
  return std::log(largest);
}

/// Looks every 1/50 of a radian up to 60 and every 2 % beyond, and bisects where the verdict changes: a band
/// narrower than that is not seen.
NonNegative function_stable(const SecondOrderStep& step, Coefficient stiffness, Coefficient damping) {
  const auto growth = [&](Coefficient h) { return matrix_log_radius(step(stiffness, damping, h)); };
  const auto stable = [&](Coefficient h) { return growth(h) <= 1e-15L * std::max(Coefficient(1), h); };
  constexpr Coefficient end = 1e8L;
  std::vector<Coefficient> edges;
  Coefficient at = 0;
  bool good = true;
  while (at < end) {
    const Coefficient next = at < 60 ? at + 0.02L : at * 1.02L;
    if (stable(next) != good) {
      Coefficient low = at, high = next;
      for (int i = 0; i < 200; ++i) {
        const Coefficient middle = low + (high - low) / 2;
        if (!(middle > low && middle < high)) break;
        (stable(middle) == good ? low : high) = middle;
      }
      edges.push_back(low);
      good = !good;
    }
    at = next;
  }
  // growth well inside the first edge: there the tolerance ends, not stability
  const bool weak = !edges.empty() && growth(0.95L * edges[0]) > 1e-17L && growth(0.9L * edges[0]) > 1e-17L;
  NonNegative out;
  for (std::size_t i = 0; i <= edges.size(); i += 2) {
    if (i == 0 && weak) continue;
    out.where.emplace_back(i == 0 ? 0 : edges[i - 1], i < edges.size() ? edges[i] : detail::infinity);
  }
  return out;
}

}  // namespace detail

}  // namespace odemark
