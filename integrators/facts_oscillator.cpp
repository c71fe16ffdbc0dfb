// Springs: limits of omega h with and without damping, and what second-order steps do to a free oscillation.
#include <algorithm>
#include <cmath>
#include <limits>

#include "integrators/facts_parts.hpp"
#include "integrators/linear_stability_parts.hpp"

namespace odemark::detail {

namespace {

bool is_drift(const SecondOrderMove& m) { return m.what == SecondOrderMove::What::drift; }

/// Without a velocity in the force all kicks are one, but that of the start once the position has moved.
bool uses_old_force(const std::vector<SecondOrderMove>& moves) {
  bool moved = false;
  for (const auto& m : moves) {
    if (m.what == SecondOrderMove::What::kick_start && moved) return true;
    moved = moved || is_drift(m);
  }
  return false;
}

bool reads_the_same_backwards(const std::vector<SecondOrderMove>& moves) {
  return std::equal(moves.begin(), moves.end(), moves.rbegin(), [](const auto& a, const auto& b) {
    return is_drift(a) == is_drift(b) && std::abs(a.weight - b.weight) < 1e-15L;
  });
}

int evaluations(const std::vector<SecondOrderMove>& moves) {
  int kicks = 0;
  bool moved = false, start_known = false;
  for (const auto& m : moves) {
    if (is_drift(m)) {
      moved = true;
      continue;
    }
    const bool of_start = m.what == SecondOrderMove::What::kick_start || !moved;
    kicks += !(of_start && start_known);
    start_known = start_known || of_start;
  }
  // the last force is the first of the next step where both see the velocity that is current
  return kicks - (moves.size() > 1 && moves.front().what == SecondOrderMove::What::kick &&
                  moves.back().what == SecondOrderMove::What::kick);
}

using Numbers = std::vector<Coefficient>;
constexpr std::size_t kept_powers = 20;  // of z^2

Numbers even_part(const RealPolynomial& p) {
  Numbers out(kept_powers, 0);
  for (std::size_t k = 0; k < p.value.size() && k / 2 < kept_powers; k += 2) out[k / 2] = p.value[k];
  return out;
}

Numbers times(const Numbers& a, const Numbers& b) {
  Numbers out(kept_powers, 0);
  for (std::size_t i = 0; i < kept_powers; ++i)
    for (std::size_t j = 0; i + j < kept_powers; ++j) out[i + j] += a[i] * b[j];
  return out;
}

/// a^power of a series that begins with 1.
Numbers to_power(const Numbers& a, Coefficient power) {
  Numbers out(kept_powers, 0);
  out[0] = 1;
  for (std::size_t n = 1; n < kept_powers; ++n) {
    for (std::size_t k = 1; k <= n; ++k)
      out[n] += (power * Coefficient(k) - Coefficient(n - k)) * a[k] * out[n - k];
    out[n] /= Coefficient(n);
  }
  return out;
}

/// det = e^(2 growth) and tr / 2 = sqrt(det) cos(theta), as series in x = z^2; from theta^2 =
/// sum 2 u^k / (k^2 binom(2k, k)) with u = 2 - 2 cos(theta).
void add_series(const Theory& theory, StabilityFacts& facts) {
  const auto m = step_matrix(theory, 1, 0);
  const Numbers q = even_part(m.denominator), inverse = to_power(q, -1);
  const Numbers determinant = times(even_part(m.determinant), times(inverse, inverse));
  for (std::size_t k = 1; k < kept_powers && !facts.log_amplification; ++k)
    if (std::abs(determinant[k]) > 1e-14L) facts.log_amplification = PowerLaw{determinant[k] / 2, int(2 * k)};
  if (!facts.log_amplification)
    facts.log_amplification = Fact<PowerLaw>::none("amplitudes of oscillations are kept");
  Numbers u = times(times(even_part(m.trace), inverse), to_power(determinant, -0.5L));
  for (auto& x : u) x = -x;
  u[0] += 2;
  Numbers square(kept_powers, 0), power = u;  // theta^2
  Coefficient weight = 1;                     // 2 / (k^2 binom(2k, k))
  for (std::size_t k = 1; k < kept_powers; ++k) {
    for (std::size_t n = 0; n < kept_powers; ++n) square[n] += weight * power[n];
    power = times(power, u);
    const auto j = Coefficient(k);  // binom(2j + 2, j + 1) = binom(2j, j) 2 (2j + 1) / (j + 1)
    weight *= j * j / ((j + 1) * 2 * (2 * j + 1));
  }
  Numbers ratio(kept_powers, 0);  // theta^2 / z^2
  for (std::size_t n = 0; n + 1 < kept_powers; ++n) ratio[n] = square[n + 1];
  if (std::abs(ratio[0] - 1) > 1e-12L) {
    facts.phase_error = PowerLaw{std::sqrt(ratio[0]) - 1, 1};
    return;
  }
  ratio[0] = 1;
  const Numbers theta = to_power(ratio, 0.5L);
  for (std::size_t k = 1; k + 1 < kept_powers; ++k)
    if (std::abs(theta[k]) > 1e-14L) {
      facts.phase_error = PowerLaw{theta[k], int(2 * k + 1)};
      return;
    }
}

}  // namespace

void add_oscillator_facts(const Theory& theory, MethodFacts& facts) {
  const auto spring = [](Coefficient zeta) { return linear_problem(2, {0, -1, 1, -2 * zeta}, true); };
  const auto free = stability_limit(theory, spring(0));
  if (free.verdict == Stability::unknown) {
    facts.oscillator_limit = Fact<Coefficient>::none(free.reason);
    facts.oscillator_windows = Fact<Intervals>::none(free.reason);
    facts.damped_limit = Fact<std::map<Coefficient, Coefficient>>::none(free.reason);
  } else {
    facts.oscillator_limit = free.verdict == Stability::unlimited ? infinity : free.limit;
    facts.oscillator_windows = free.later_bands;
    std::map<Coefficient, Coefficient> damped;
    for (const Coefficient zeta : damping_ratios) {
      const auto found = stability_limit(theory, spring(zeta));
      damped[zeta] = found.verdict == Stability::unlimited ? infinity : found.limit;
    }
    facts.damped_limit = std::move(damped);
  }
  if (!theory.oscillator.xx.empty()) add_series(theory, facts.stability);
  if (theory.moves.empty()) return;
  const bool old_force = uses_old_force(theory.moves);
  add_series(theory, facts.stability);
  const auto step = step_matrix(theory, 1, 0);
  auto defect = step.denominator * step.denominator - step.determinant;
  defect.clean();
  facts.symplectic = {!old_force && defect.is_zero(), "for forces without velocity"};
  facts.symmetric = {!old_force && reads_the_same_backwards(theory.moves), "for forces without velocity"};
  facts.evaluations_per_step = {evaluations(theory.moves), "of the force"};
  facts.linear_solves_per_step = 0;
}

}  // namespace odemark::detail
