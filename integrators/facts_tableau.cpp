// Facts of Runge-Kutta and Rosenbrock tableaux: orders, structure, symplecticity, symmetry.
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>

#include "integrators/facts_parts.hpp"
#include "integrators/tree_order.hpp"

namespace odemark::detail {

namespace {

constexpr Coefficient close = 1e-14L;  // equal, for coefficients typed with 16 digits or computed

struct View {
  std::size_t s;
  const std::vector<Coefficient>&a, &b;
  Coefficient A(std::size_t i, std::size_t j) const { return a[i * s + j]; }
  Coefficient c(std::size_t i) const {
    Coefficient sum = 0;
    for (std::size_t j = 0; j < s; ++j) sum += A(i, j);
    return sum;
  }
  Coefficient size() const {
    Coefficient largest = 0;
    for (const Coefficient x : a) largest = std::max(largest, std::abs(x));
    for (const Coefficient x : b) largest = std::max(largest, std::abs(x));
    return largest;
  }
};

bool last_row_is_b(const View& v) {
  for (std::size_t j = 0; j < v.s; ++j)
    if (std::abs(v.A(v.s - 1, j) - v.b[j]) > close * v.size()) return false;
  return true;
}

bool row_is_zero(const View& v, std::size_t row) {
  for (std::size_t j = 0; j < v.s; ++j)
    if (v.A(row, j) != 0) return false;
  return true;
}

/// Largest q with A c^(k-1) = c^k / k and b . c^(k-1) = 1 / k for k <= q.
int stage_order(const View& v) {
  for (int k = 1;; ++k) {
    const auto power = [k](Coefficient c) { return k == 1 ? 1 : std::pow(c, Coefficient(k - 1)); };
    Coefficient quadrature = -1 / Coefficient(k);
    for (std::size_t j = 0; j < v.s; ++j) quadrature += v.b[j] * power(v.c(j));
    if (std::abs(quadrature) > close * v.size() || k > 40) return k - 1;
    for (std::size_t i = 0; i < v.s; ++i) {
      Coefficient residual = -v.c(i) * power(v.c(i)) / Coefficient(k);
      for (std::size_t j = 0; j < v.s; ++j) residual += v.A(i, j) * power(v.c(j));
      if (std::abs(residual) > close * std::max(Coefficient(1), v.size())) return k - 1;
    }
  }
}

/// b_i a_ij + b_j a_ji - b_i b_j (E. Hairer, G. Wanner, Solving ODEs II, IV.12); 0: symplectic.
Coefficient product_entry(const View& v, std::size_t i, std::size_t j) {
  return v.b[i] * v.A(i, j) + v.b[j] * v.A(j, i) - v.b[i] * v.b[j];
}

bool conserves_products(const View& v) {
  for (std::size_t i = 0; i < v.s; ++i)
    for (std::size_t j = 0; j < v.s; ++j)
      if (std::abs(product_entry(v, i, j)) > close * v.size() * v.size()) return false;
  return true;
}

/// Is there a numbering of the stages with a_(p(i) p(j)) + a_ij = b_j? Tried stage by stage.
bool mirrored(const View& v, std::vector<std::size_t>& image) {
  const std::size_t i = image.size();
  if (i == v.s) return true;
  for (std::size_t candidate = 0; candidate < v.s; ++candidate) {
    if (std::find(image.begin(), image.end(), candidate) != image.end()) continue;
    image.push_back(candidate);
    bool fits = std::abs(v.b[candidate] - v.b[i]) <= close * v.size();
    for (std::size_t j = 0; j <= i && fits; ++j)
      fits = std::abs(v.A(candidate, image[j]) + v.A(i, j) - v.b[j]) <= close * v.size() &&
             std::abs(v.A(image[j], candidate) + v.A(j, i) - v.b[i]) <= close * v.size();
    if (fits && mirrored(v, image)) return true;
    image.pop_back();
  }
  return false;
}

void add_embedded(const Theory& theory, int claimed, MethodFacts& facts) {
  const Tableau t = embedded_tableau(theory.tableau);
  const auto proof = tree_order(t, t.b, claimed + 2);
  facts.embedded_order = {proof.order, proof.exact ? "proved in integers" : "proved to rounding"};
  facts.embedded_error_constant = proof.principal_error_norm;
  facts.embedded = stability_facts(stability_function(t.stages, implicit_matrix(t), t.b, proof.order));
}

}  // namespace

std::vector<Coefficient> implicit_matrix(const Tableau& t) {
  std::vector<Coefficient> out = t.a;
  for (std::size_t i = 0; i < t.gamma.size(); ++i) out[i] += t.gamma[i];
  return out;
}

Tableau embedded_tableau(const Tableau& t) {
  Tableau out = t;
  out.b = t.b_embedded, out.b_embedded.clear(), out.embedded_start = 0;
  if (t.embedded_start == 0) return out;
  out.stages = t.stages + 1;
  out.b.insert(out.b.begin(), t.embedded_start);
  out.a.assign(out.stages * out.stages, 0);
  for (std::size_t i = 0; i < t.stages; ++i)
    for (std::size_t j = 0; j < t.stages; ++j) out.a[(i + 1) * out.stages + j + 1] = t.a[i * t.stages + j];
  return out;
}

bool is_explicit(const Tableau& t) {
  const auto a = implicit_matrix(t);
  for (std::size_t i = 0; i < t.stages; ++i)
    for (std::size_t j = i; j < t.stages; ++j)
      if (a[i * t.stages + j] != 0) return false;
  return true;
}

bool algebraically_stable(std::size_t s, const std::vector<Coefficient>& a,
                          const std::vector<Coefficient>& b) {
  const View v{s, a, b};
  if (std::any_of(b.begin(), b.end(), [](Coefficient x) { return x < -close; })) return false;
  using Matrix = Eigen::Matrix<Coefficient, Eigen::Dynamic, Eigen::Dynamic>;
  const auto n = static_cast<Eigen::Index>(s);
  Matrix m(n, n);
  for (std::size_t i = 0; i < s; ++i)
    for (std::size_t j = 0; j < s; ++j)
      m(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) = product_entry(v, i, j);
  const Eigen::SelfAdjointEigenSolver<Matrix> solver(m, Eigen::EigenvaluesOnly);
  return solver.eigenvalues().minCoeff() >= -close * Coefficient(s) * v.size() * v.size();
}

Theory stability_function(std::size_t s, const std::vector<Coefficient>& a, const std::vector<Coefficient>& b,
                          int order) {
  Theory out;
  out.denominator = {1};
  bool lower = true;
  for (std::size_t i = 0; i < s; ++i)
    for (std::size_t j = i; j < s; ++j) lower = lower && a[i * s + j] == 0;
  const auto coefficients =
      [s](const std::vector<Coefficient>& m) {  // of det(I - z M), with rounding noise out
        std::vector<Coefficient> power(s * s, 0), size(s * s, 0), q{1};
        for (std::size_t i = 0; i < s; ++i) power[i * s + i] = size[i * s + i] = 1;
        for (std::size_t k = 1; k <= s; ++k) {
          std::vector<Coefficient> product(s * s, 0), sizes(s * s, 0);
          for (std::size_t i = 0; i < s; ++i)
            for (std::size_t l = 0; l < s; ++l)
              for (std::size_t j = 0; j < s; ++j) {
                product[i * s + j] += m[i * s + l] * power[l * s + j];
                sizes[i * s + j] += std::abs(m[i * s + l]) * size[l * s + j];
              }
          Coefficient trace = 0, traces = 0;
          for (std::size_t i = 0; i < s; ++i) trace += product[i * s + i], traces += sizes[i * s + i];
          q.push_back(std::abs(trace) <= 1e-16L * traces ? 0 : -trace / Coefficient(k));
          power = product, size = sizes;
          for (std::size_t i = 0; i < s; ++i)
            power[i * s + i] += q.back(), size[i * s + i] += traces / Coefficient(k);
        }
        while (q.size() > 1 && q.back() == 0) q.pop_back();
        return q;
      };
  if (!lower) {
    auto shifted = a;
    for (std::size_t i = 0; i < s; ++i)
      for (std::size_t j = 0; j < s; ++j) shifted[i * s + j] -= b[j];
    out.numerator = coefficients(shifted), out.denominator = coefficients(a);
    return out;
  }
  out.numerator = {1};
  std::vector<Coefficient> power(s, 1), size(s, 1);
  Coefficient factorial = 1;
  for (std::size_t k = 1; k <= s; ++k) {
    Coefficient sum = 0, sizes = 0;
    for (std::size_t i = 0; i < s; ++i) sum += b[i] * power[i], sizes += std::abs(b[i]) * size[i];
    factorial *= Coefficient(k);
    out.numerator.push_back(int(k) <= order ? 1 / factorial : std::abs(sum) <= 1e-15L * sizes ? 0 : sum);
    std::vector<Coefficient> next(s, 0), next_size(s, 0);
    for (std::size_t i = 0; i < s; ++i)
      for (std::size_t j = 0; j < i; ++j) {
        next[i] += a[i * s + j] * power[j];
        next_size[i] += std::abs(a[i * s + j]) * size[j];
      }
    power = next, size = next_size;
  }
  while (out.numerator.size() > 1 && out.numerator.back() == 0) out.numerator.pop_back();
  return out;
}

void add_tableau_facts(const Theory& theory, int order, int embedded_order, MethodFacts& facts) {
  const Tableau& t = theory.tableau;
  const bool rosenbrock = !t.gamma.empty(), explicit_steps = is_explicit(t);
  const auto matrix = implicit_matrix(t);
  const View v{t.stages, rosenbrock ? matrix : t.a, t.b};
  facts.stages = int(t.stages);
  const auto proof = tree_order(t, t.b, order + 2);
  facts.order = {proof.order, proof.exact ? "proved in integers" : "proved to rounding"};
  facts.error_constant = proof.principal_error_norm;
  // a Rosenbrock stage asks for f at the argument that alpha gives, whatever the matrix adds afterwards
  const View asked{t.stages, t.a, t.b};
  const bool fsal = t.stages > 1 && row_is_zero(asked, 0) && last_row_is_b(asked);
  facts.fsal = fsal;
  const Theory function = stability_function(t.stages, matrix, t.b, proof.order);
  facts.stability = stability_facts(function);
  if (embedded_order > 0 && !t.b_embedded.empty()) add_embedded(theory, embedded_order, facts);
  int implicit_stages = 0;
  bool triangular = true;
  for (std::size_t i = 0; i < t.stages; ++i) {
    implicit_stages += matrix[i * t.stages + i] != 0;
    for (std::size_t j = i + 1; j < t.stages; ++j) triangular = triangular && matrix[i * t.stages + j] == 0;
  }
  int repeated = 0;  // Rosenbrock stages that ask where the stage before did
  for (std::size_t i = 1; rosenbrock && i < t.stages; ++i) {
    Coefficient apart = 0;
    for (std::size_t j = 0; j < t.stages; ++j)
      apart += std::abs(t.a[i * t.stages + j] - t.a[(i - 1) * t.stages + j]);
    repeated += apart < 1e-15L;
  }
  if (explicit_steps || rosenbrock)
    facts.evaluations_per_step = int(t.stages) - (fsal ? 1 : 0) - repeated;
  else
    facts.evaluations_per_step = Fact<int>::none("depends on the iterations that solve the stages");
  if (explicit_steps)
    facts.linear_solves_per_step = 0;
  else if (rosenbrock)
    facts.linear_solves_per_step = int(t.stages);
  else if (triangular)
    facts.linear_solves_per_step = {implicit_stages, "of the size of the system, in every Newton iteration"};
  else
    facts.linear_solves_per_step = {1, "coupled, of all stages at once, in every Newton iteration"};
  facts.stiffly_accurate = !explicit_steps && last_row_is_b(v);
  if (rosenbrock) {
    const std::string why = "a notion of Runge-Kutta stages; a linearly implicit step has others";
    facts.stage_order = Fact<int>::none(why);
    facts.algebraically_stable = facts.symplectic = facts.symmetric = Fact<bool>::none(why);
    facts.ssp_coefficient = facts.internal_amplification = Fact<Coefficient>::none(why);
    return;
  }
  facts.stage_order = stage_order(v);
  facts.algebraically_stable = algebraically_stable(t.stages, t.a, t.b);
  facts.symplectic = conserves_products(v);
  std::vector<std::size_t> image;
  facts.symmetric = !explicit_steps && mirrored(v, image);
  facts.ssp_coefficient = ssp_coefficient(t.stages, t.a, t.b);
  facts.internal_amplification = internal_amplification(t, function);
}

}  // namespace odemark::detail
