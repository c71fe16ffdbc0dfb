// One compiled step on linear problems against the polynomials of the coefficients.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "bench/linear_block.hpp"
#include "bench/measured_facts.hpp"
#include "integrators/facts_parts.hpp"
#include "integrators/linear_stability_parts.hpp"
#include "reference/any_problem.hpp"

namespace odemark {

namespace {

using Wide = long double;

/// The point of worst |difference| / bound.
struct Worst {
  Wide ratio = -1, difference = 0, bound = 0;
  std::string where;

  void look(Wide off, Wide allowed, const std::string& at) {
    const Wide r = off / allowed;
    if (r <= ratio || ratio != ratio) return;  // a NaN comes through, and stays
    ratio = r, difference = off, bound = allowed, where = at;
  }
};

MeasuredFact result(const char* name, const std::string& scalar, const Worst& worst, int points) {
  MeasuredFact fact;
  fact.fact = name, fact.scalar = scalar;
  fact.difference = double(worst.difference), fact.bound = double(worst.bound);
  fact.agrees = worst.ratio <= 1;
  fact.note = fmt::format("{} points; nearest to its bound at {}", points, worst.where);
  return fact;
}

std::string text(WideComplex z) {
  return fmt::format("z = {:.4g}{:+.4g}i", double(z.real()), double(z.imag()));
}

WideComplex at(const std::vector<Coefficient>& p, WideComplex z) {
  WideComplex sum = 0;
  for (std::size_t k = p.size(); k-- > 0;) sum = sum * z + p[k];
  return sum;
}
Wide size_at(const std::vector<Coefficient>& p, Wide r) {
  Wide sum = 0;
  for (std::size_t k = p.size(); k-- > 0;) sum = sum * r + std::abs(p[k]);
  return sum;
}

/// Rings of points in the left and right half-planes out to 1.2 times the larger of the intervals, or 4;
/// coordinates that float holds exactly.
std::vector<WideComplex> disk(const StabilityFacts& facts) {
  Wide radius = 0;
  for (const auto* interval : {&facts.real_interval, &facts.imaginary_interval})
    if (*interval && std::isfinite(**interval)) radius = std::max(radius, **interval);
  radius = radius == 0 ? 4 : 1.2L * radius;
  std::vector<WideComplex> points;
  for (int ring = 1; ring <= 4; ++ring)
    for (int i = 0; i < 12; ++i) {
      const Wide angle = std::numbers::pi_v<Wide> * (i + ring / 4.0L) / 6;
      const auto exact = [](Wide x) { return std::round(x * 1024) / 1024; };
      const Wide r = radius * ring / 4;
      points.emplace_back(exact(r * std::cos(angle)), exact(r * std::sin(angle)));
    }
  return points;
}

/// sum |b| |A|^(k-1) 1 of an explicit tableau: what a step really adds up, which may be far above |c_k|.
std::vector<Coefficient> summed_sizes(const Tableau& t, const std::vector<Coefficient>& b) {
  std::vector<Coefficient> out{1}, power(t.stages, 1);
  for (std::size_t k = 1; k <= t.stages; ++k) {
    Coefficient sum = 0;
    std::vector<Coefficient> next(t.stages, 0);
    for (std::size_t i = 0; i < t.stages; ++i) {
      sum += std::abs(b[i]) * power[i];
      for (std::size_t j = 0; j < t.stages; ++j) next[i] += std::abs(t.a[i * t.stages + j]) * power[j];
    }
    out.push_back(sum), power = next;
  }
  return out;
}

template <class T>
void measure_function(const AnyMethod& method, const Theory& theory, const StabilityFacts& facts,
                      const std::string& scalar, std::vector<MeasuredFact>& out) {
  const Wide unit = std::numeric_limits<T>::epsilon() / 2;
  const Tableau& tableau = theory.tableau;
  const bool explicit_steps = tableau.stages > 0 && detail::is_explicit(tableau);
  const auto sizes = explicit_steps ? summed_sizes(tableau, tableau.b) : theory.numerator;
  const bool pair = tableau.stages > 0 && !tableau.b_embedded.empty() && method.embedded_order > 0;
  const Tableau other = pair ? detail::embedded_tableau(tableau) : Tableau{};
  Theory embedded;
  if (pair)
    embedded = detail::stability_function(other.stages, detail::implicit_matrix(other), other.b,
                                          method.embedded_order);
  // an estimate is used by its size, so that either sign will do: one sign, for all z
  Worst main, estimate, negative;
  // sizes already hold the magnitudes of explicit weights
  const Wide cancelled = explicit_steps ? 1 : theory.rounding_amplification;
  int points = 0;
  for (const WideComplex z : disk(facts)) {
    const LinearBlock<T> block{T(z.real()), T(z.imag())};
    const Wide r = std::abs(z);
    WideComplex expected;
    Wide amplified;  // what roundings in the step are multiplied with
    if (theory.exact_on_linear_part) {
      expected = std::exp(z), amplified = std::exp(r);
    } else {
      const WideComplex q = at(theory.denominator, z);
      if (std::abs(q) < 0.05L * size_at(theory.denominator, r)) continue;  // next to a pole
      expected = at(theory.numerator, z) / q;
      amplified = (size_at(sizes, r) + std::abs(expected) * size_at(theory.denominator, r)) / std::abs(q);
    }
    const auto step = method.runs<T>().transition(block.view(), T(1));
    ++points;
    const Wide allowed = 20 * Wide(theory.numerator.size() + 1) * unit * amplified * cancelled;
    const WideComplex found(step.columns[0], step.columns[1]);
    main.look(step.solved ? std::abs(found - expected) : std::numeric_limits<Wide>::infinity(), allowed,
              text(z));
    if (!pair) continue;
    const WideComplex gap = expected - at(embedded.numerator, z) / at(embedded.denominator, z);
    const WideComplex said(step.errors[0], step.errors[1]);
    const Wide gap_size = explicit_steps
                              ? size_at(summed_sizes(other, other.b), r)
                              : size_at(embedded.numerator, r) / std::abs(at(embedded.denominator, z));
    // stiff pairs send it through the matrix that they have factored (Hairer & Wanner, Solving ODEs II, IV.8)
    const WideComplex filtered = gap / (Wide(1) - theory.estimate_filter * z);
    const Wide slack = allowed + 20 * Wide(embedded.numerator.size()) * unit * gap_size;
    estimate.look(std::abs(said - filtered), slack, text(z));
    negative.look(std::abs(said + filtered), slack, text(z));
  }
  if (negative.ratio < estimate.ratio) estimate = negative;
  if (points > 0) out.push_back(result("R(z)", scalar, main, points));
  if (pair && points > 0) out.push_back(result("error estimate on y' = lambda y", scalar, estimate, points));
}

/// det(w - M) of a small real matrix by elimination.
Wide determinant(std::vector<Wide> m, std::size_t n, Wide w) {
  for (auto& x : m) x = -x;
  for (std::size_t i = 0; i < n; ++i) m[i * n + i] += w;
  Wide product = 1;
  for (std::size_t c = 0; c < n; ++c) {
    std::size_t pivot = c;
    for (std::size_t r = c + 1; r < n; ++r)
      if (std::abs(m[c * n + r]) > std::abs(m[c * n + pivot])) pivot = r;
    if (m[c * n + pivot] == 0) return 0;
    if (pivot != c) {
      product = -product;
      for (std::size_t k = 0; k < n; ++k) std::swap(m[k * n + c], m[k * n + pivot]);
    }
    product *= m[c * n + c];
    for (std::size_t r = c + 1; r < n; ++r) {
      const Wide factor = m[c * n + r] / m[c * n + c];
      for (std::size_t k = c; k < n; ++k) m[k * n + r] -= factor * m[k * n + c];
    }
  }
  return product;
}

/// The characteristic polynomial of the step's matrix, at a real w outside the unit circle, is |Pi(z, w)|^2
/// over its leading coefficient, times powers of w for what the step keeps beyond its history.
template <class T>
void measure_multistep(const AnyMethod& method, const Theory& theory, const StabilityFacts& facts,
                       const std::string& scalar, std::vector<MeasuredFact>& out) {
  auto c = theory.characteristic;
  if (c.empty()) {
    c = {theory.rho, theory.sigma};
    for (auto& s : c[1]) s = -s;
  }
  std::size_t degree = 0;
  for (const auto& row : c)
    for (std::size_t j = 0; j < row.size(); ++j)
      if (row[j] != 0) degree = std::max(degree, j);
  const auto coefficient = [&](std::size_t j, WideComplex z) {
    WideComplex sum = 0;
    for (std::size_t k = c.size(); k-- > 0;) sum = sum * z + (j < c[k].size() ? c[k][j] : 0);
    return sum;
  };
  const Wide unit = std::numeric_limits<T>::epsilon() / 2;
  Worst worst;
  int points = 0;
  for (const WideComplex z : disk(facts)) {
    const WideComplex lead = coefficient(degree, z);
    Wide lead_size = 0;
    for (std::size_t k = 0; k < c.size(); ++k)
      lead_size += degree < c[k].size() ? std::abs(c[k][degree]) * std::pow(std::abs(z), Wide(k)) : 0;
    if (std::abs(lead) < 0.05L * lead_size) continue;
    const LinearBlock<T> block{T(z.real()), T(z.imag())};
    const auto step = method.runs<T>().transition(block.view(), T(1));
    const std::vector<Wide> matrix(step.columns.begin(), step.columns.end());
    for (const Wide w : {1.5L, -1.5L}) {
      WideComplex pi = 0;
      Wide size = 0;
      for (std::size_t j = 0; j <= degree; ++j) {
        const WideComplex term = coefficient(j, z) / lead * std::pow(w, Wide(j));
        pi += term, size += std::abs(term);
      }
      if (step.size < 2 * degree) {
        worst.look(std::numeric_limits<Wide>::infinity(), 1, text(z));
        break;
      }
      const Wide spare = std::pow(w, Wide(step.size - 2 * degree));
      ++points;
      worst.look(std::abs(determinant(matrix, step.size, w) - spare * std::norm(pi)),
                 40 * Wide(degree + 2) * unit * std::abs(spare) * size * size, text(z));
    }
  }
  if (points > 0) out.push_back(result("characteristic polynomial", scalar, worst, points));
}

/// The matrix of a step on (x, v) of springs.
template <class T>
void measure_second_order(const AnyMethod& method, const Theory& theory, const std::string& scalar,
                          std::vector<MeasuredFact>& out) {
  const Wide unit = std::numeric_limits<T>::epsilon() / 2;
  Worst worst;
  int points = 0;
  for (const char* settings : {"zeta=0", "zeta=0.125", "zeta=0.5", "zeta=2"}) {
    const AnyProblem spring = find_problem(suite_families(), "damped_spring", settings);
    if (!spring.homogeneous || (method.needs & ~spring.abilities) != 0) continue;
    const auto& wide = spring.homogeneous->system<Wide>();
    const std::vector<Wide> origin(2, 0);
    std::vector<Wide> jacobian(4, 0);
    wide.jacobian(0, origin, MatrixView<Wide>{jacobian.data(), 2});
    const Wide k = -jacobian[1], d = -jacobian[3];
    if (d != 0 && !theory.oscillator.xx.empty()) continue;
    for (const Wide z : {0.125L, 0.5L, 1.0L, 1.5L, 2.0L, 3.0L}) {
      const Wide h = static_cast<Wide>(T(z / std::sqrt(k)));
      const auto expected = second_order_matrix(theory, k, d, h);
      const auto m = method.runs<T>().transition(spring.homogeneous->system<T>(), T(h)).columns;
      if (m.size() != 4 || expected.size() != 4) return;
      // each move may add at most h times the other component and its own damping to the size of an entry
      Wide size = 8;
      for (const auto& move : theory.moves) size *= 1 + std::abs(move.weight) * h * (k + d + 1);
      if (theory.moves.empty())
        for (const Wide entry : expected) size += 32 * entry * entry + 8 * h * h * (k + d + 1) * (k + d + 1);
      ++points;
      for (std::size_t i = 0; i < 4; ++i)
        worst.look(std::abs(Wide(m[i]) - expected[i]), 8 * unit * size,
                   fmt::format("{}, z = {}", settings, double(z)));
    }
  }
  if (points > 0) out.push_back(result("matrix on springs", scalar, worst, points));
}

template <class T>
std::vector<MeasuredFact> linear_facts(const AnyMethod& method, const std::string& scalar) {
  std::vector<MeasuredFact> out;
  if (!method.runs<T>().transition || !method.theory) return out;
  const Theory theory = method.theory();
  if (detail::is_second_order(theory)) {
    measure_second_order<T>(method, theory, scalar, out);
    return out;
  }
  const LinearBlock<T> block{T(-1), T(0)};
  if ((method.needs & ~block.view().abilities) != 0 || !theory.blank_reason.empty()) return out;
  const StabilityFacts facts = detail::stability_facts(theory);
  if (detail::takes_several_steps(theory))
    measure_multistep<T>(method, theory, facts, scalar, out);
  else if (!theory.numerator.empty() || theory.exact_on_linear_part)
    measure_function<T>(method, theory, facts, scalar, out);
  return out;
}

}  // namespace

std::vector<MeasuredFact> detail::measure_linear(const AnyMethod& method, const std::string& scalar) {
  return scalar == "float" ? linear_facts<float>(method, scalar) : linear_facts<double>(method, scalar);
}

}  // namespace odemark
