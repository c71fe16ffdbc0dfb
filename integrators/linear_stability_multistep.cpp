// Multistep methods along a ray: where roots of rho(w) - z sigma(w) meet the unit circle, and on which side
// they are in between.
#include <algorithm>
#include <cmath>
#include <limits>

#include "integrators/linear_stability_parts.hpp"

namespace odemark::detail {

namespace {

constexpr Coefficient infinity = std::numeric_limits<Coefficient>::infinity();

struct ComplexPolynomial {
  RealPolynomial re, im;
};

/// p(w) (1 - i t)^degree with w = (1 + i t) / (1 - i t): the unit circle becomes the real line, w = 1 is t =
/// 0.
ComplexPolynomial on_real_line(const std::vector<Coefficient>& p) {
  ComplexPolynomial sum;
  for (std::size_t j = 0; j < p.size(); ++j) {
    ComplexPolynomial term{RealPolynomial({p[j]}), RealPolynomial({0})};
    for (std::size_t factor = 0; factor + 1 < p.size(); ++factor) {
      const RealPolynomial it({0, factor < j ? 1.0L : -1.0L});
      term = {term.re - it * term.im, term.im + it * term.re};
    }
    sum = {sum.re + term.re, sum.im + term.im};
  }
  return sum;
}

WideComplex at(const std::vector<Coefficient>& p, WideComplex w) {
  WideComplex sum = 0;
  for (std::size_t k = p.size(); k-- > 0;) sum = sum * w + p[k];
  return sum;
}

/// Where the whole ray has a root on the circle (symmetric methods), stability changes where two of them
/// meet.
std::vector<Coefficient> collisions(const Theory& theory, WideComplex direction) {
  const auto &rho = theory.rho, &sigma = theory.sigma;
  std::vector<WideComplex> bend(rho.size() + sigma.size() - 1, 0);  // rho' sigma - rho sigma'
  for (std::size_t j = 0; j < rho.size(); ++j)
    for (std::size_t k = 0; k < sigma.size(); ++k)
      if (j + k > 0) bend[j + k - 1] += (Coefficient(j) - Coefficient(k)) * rho[j] * sigma[k];
  std::vector<Coefficient> out;
  for (const auto& w : polynomial_roots(bend)) {
    if (std::abs(std::abs(w) - 1) > 1e-6L || std::abs(at(sigma, w)) < 1e-9L) continue;
    const Coefficient r = (at(rho, w) / at(sigma, w) / direction).real();
    if (r > 1e-9L) out.push_back(r);
  }
  return out;
}

}  // namespace

Coefficient largest_multistep_root(const Theory& theory, WideComplex z) {
  std::vector<WideComplex> c(std::max(theory.rho.size(), theory.sigma.size()), 0);
  for (std::size_t k = 0; k < theory.rho.size(); ++k) c[k] += theory.rho[k];
  for (std::size_t k = 0; k < theory.sigma.size(); ++k) c[k] -= z * theory.sigma[k];
  Coefficient largest = 0;
  for (const auto& w : polynomial_roots(c)) largest = std::max(largest, std::abs(w));
  return largest;
}

bool zero_stable(const Theory& theory) {
  const auto roots = polynomial_roots({theory.rho.begin(), theory.rho.end()});
  for (std::size_t i = 0; i < roots.size(); ++i) {
    if (std::abs(roots[i]) > 1 + 1e-7L) return false;
    if (std::abs(roots[i]) < 1 - 1e-7L) continue;
    for (std::size_t j = 0; j < i; ++j)
      if (std::abs(roots[i] - roots[j]) < 1e-6L) return false;  // a double root on the circle
  }
  return true;
}

NonNegative multistep_stable_along_ray(const Theory& theory, WideComplex direction) {
  auto rho = theory.rho, sigma = theory.sigma;
  rho.resize(std::max(rho.size(), sigma.size()), 0), sigma.resize(rho.size(), 0);
  const auto a = on_real_line(rho), b = on_real_line(sigma);
  // z = rho / sigma lies on the ray where rho conj(sigma) conj(direction) is real and positive
  const RealPolynomial re = a.re * b.re + a.im * b.im, im = a.im * b.re - a.re * b.im;
  const RealPolynomial c({direction.real()}), s({direction.imag()});
  RealPolynomial across = im * c - re * s;
  const RealPolynomial along = re * c + im * s, size = b.re * b.re + b.im * b.im;
  across.clean();  // the multiple root at t = 0 (consistency and order) becomes exact, and is no candidate
  std::vector<Coefficient> edges;
  Coefficient tolerance = 0;
  if (across.is_zero()) {
    edges = collisions(theory, direction);
    tolerance = 1e-10L;  // the roots stay on the circle; they are simple between collisions
  } else {
    const auto add = [&](Coefficient r) {
      if (r > 0 && r < infinity) edges.push_back(r);
    };
    for (const Coefficient t : positive_roots(across)) add(along(t) / size(t));
    RealPolynomial mirrored = across;
    for (std::size_t k = 1; k < mirrored.value.size(); k += 2) mirrored.value[k] = -mirrored.value[k];
    for (const Coefficient t : positive_roots(mirrored)) add(along(-t) / size(-t));
    const WideComplex r = at(theory.rho, -1) / at(theory.sigma, -1) / direction;
    if (std::abs(r.imag()) <= 1e-14L * std::abs(r)) add(r.real());  // w = -1, where t is infinite
  }
  std::sort(edges.begin(), edges.end());
  edges.insert(edges.begin(), 0);
  NonNegative out;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const bool last = i + 1 == edges.size();
    const Coefficient end = last ? infinity : edges[i + 1];
    if (!last && end - edges[i] <= 1e-15L * end) continue;  // the same crossing found twice
    const Coefficient middle = last ? 2 * edges[i] + 1 : (edges[i] + end) / 2;
    if (!(largest_multistep_root(theory, middle * direction) <= 1 + tolerance)) continue;
    if (!out.where.empty() && out.where.back().second >= edges[i] * (1 - 1e-14L)) {
      out.touches.push_back(edges[i]);
      out.where.back().second = end;
    } else {
      out.where.emplace_back(edges[i], end);
    }
  }
  return out;
}

}  // namespace odemark::detail
