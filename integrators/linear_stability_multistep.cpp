// Multistep methods along a ray: where roots of the characteristic polynomial meet the unit circle, and on
// which side they are in between.
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "integrators/linear_stability_parts.hpp"

namespace odemark::detail {

namespace {

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

/// Where the whole ray has a root on the circle (symmetric methods), stability changes where two of them
/// meet.
std::vector<Coefficient> collisions(const Theory& theory, WideComplex direction) {
  const auto &rho = theory.rho, &sigma = theory.sigma;
  if (rho.empty()) return {};  // a correction made once leaves no such ray
  std::vector<WideComplex> bend(rho.size() + sigma.size() - 1, 0);  // rho' sigma - rho sigma'
  for (std::size_t j = 0; j < rho.size(); ++j)
    for (std::size_t k = 0; k < sigma.size(); ++k)
      if (j + k > 0) bend[j + k - 1] += (Coefficient(j) - Coefficient(k)) * rho[j] * sigma[k];
  std::vector<Coefficient> out;
  for (const auto& w : polynomial_roots(bend)) {
    if (std::abs(std::abs(w) - 1) > 1e-6L || std::abs(value_at(sigma, w)) < 1e-9L) continue;
    const Coefficient r = (value_at(rho, w) / value_at(sigma, w) / direction).real();
    if (r > 1e-9L) out.push_back(r);
  }
  return out;
}

/// Points r > 0 of a ray where a root lies on the circle, from places on the circle that are nearly right.
class Crossings {
 public:
  Crossings(const Theory& theory, WideComplex direction)
      : chi_(characteristic_of(theory)), direction_(direction) {}

  std::vector<Coefficient> found;

  void look_at(WideComplex w) {
    std::vector<WideComplex> in_z;
    for (const auto& c : chi_) in_z.push_back(value_at(c, w));
    for (const WideComplex& z : polynomial_roots(in_z)) {
      const WideComplex along = z / direction_;
      // at w = 1 one z is 0, to rounding: not a crossing
      if (along.real() > 1e-12L && along.real() < infinity && std::abs(along.imag()) <= 1e-4L * along.real())
        polish(std::arg(w), along.real());
    }
  }

 private:
  /// Newton's iteration on (angle, r): two real equations. What is not a crossing does not converge.
  void polish(Coefficient angle, Coefficient r) {
    const Coefficient guess = r;
    for (int i = 0; i < 60; ++i) {
      const auto [value, by_angle, by_r, size] = evaluate(angle, r);
      if (std::abs(value) <= 8 * std::numeric_limits<Coefficient>::epsilon() * size) break;
      const Coefficient determinant = by_angle.real() * by_r.imag() - by_angle.imag() * by_r.real();
      if (determinant == 0) break;
      angle -= (value.real() * by_r.imag() - value.imag() * by_r.real()) / determinant;
      r -= (by_angle.real() * value.imag() - by_angle.imag() * value.real()) / determinant;
    }
    const auto end = evaluate(angle, r);
    if (std::abs(end.value) <= 1e-15L * end.size && std::abs(r - guess) <= 1e-3L * guess) found.push_back(r);
  }

  struct Value {
    WideComplex value, by_angle, by_r;
    Coefficient size;
  };
  Value evaluate(Coefficient angle, Coefficient r) const {
    Value out{0, 0, 0, 0};
    const WideComplex z = r * direction_;
    for (std::size_t k = 0; k < chi_.size(); ++k)
      for (std::size_t j = 0; j < chi_[k].size(); ++j) {
        if (chi_[k][j] == 0) continue;
        WideComplex power = 1;
        for (std::size_t i = 0; i < k; ++i) power *= z;
        const WideComplex term = chi_[k][j] * power * std::polar(1.0L, Coefficient(j) * angle);
        out.value += term, out.size += std::abs(term);
        out.by_angle += WideComplex(0, Coefficient(j)) * term;
        out.by_r += Coefficient(k) / r * term;
      }
    return out;
  }

  std::vector<std::vector<Coefficient>> chi_;
  WideComplex direction_;
};

/// A polynomial in t that vanishes where sum_k A_k(t) (r direction)^k = 0 has a real solution r: the
/// resultant of its real and its imaginary part.
RealPolynomial eliminated(const std::vector<std::vector<Coefficient>>& chi, WideComplex direction) {
  std::vector<RealPolynomial> re, im;
  WideComplex power = 1;
  for (const auto& c : chi) {
    const auto a = on_real_line(c);
    const RealPolynomial x({power.real()}), y({power.imag()});
    re.push_back(a.re * x - a.im * y), im.push_back(a.re * y + a.im * x);
    power *= direction;
  }
  const auto minor = [&](std::size_t i, std::size_t j) { return re[i] * im[j] - re[j] * im[i]; };
  RealPolynomial out = chi.size() == 2 ? minor(0, 1) : minor(0, 2) * minor(0, 2) - minor(0, 1) * minor(1, 2);
  out.clean();  // the multiple root at t = 0 (consistency and order) becomes exact, and is no candidate
  return out;
}

/// e^z - 1 without cancellation.
WideComplex exp_minus_one(WideComplex z) {
  const Coefficient half = std::sin(z.imag() / 2);
  return {std::expm1(z.real()) * std::cos(z.imag()) - 2 * half * half,
          std::exp(z.real()) * std::sin(z.imag())};
}

/// delta such that e^(z + delta) is a root: from the expansion of the characteristic polynomial at w = e^z,
/// whose terms vanish up to the order, whatever the digits of the coefficients say.
std::optional<WideComplex> principal_defect(const std::vector<std::vector<Coefficient>>& chi, WideComplex z) {
  WideComplex residual = 0, power = 1;
  bool leading = true;
  for (std::size_t n = 0; n < 80; ++n, power *= z) {
    Coefficient sum = 0, size = 0;
    for (std::size_t k = 0; k < chi.size() && k <= n; ++k)
      for (std::size_t j = 0; j < chi[k].size(); ++j) {
        Coefficient term = chi[k][j];
        for (std::size_t i = 1; i <= n - k; ++i) term *= Coefficient(j) / Coefficient(i);
        sum += term, size += std::abs(term);
      }
    if (leading && std::abs(sum) <= 1e-15L * size) continue;
    leading = false;
    residual += sum * power;
  }
  std::vector<WideComplex> weights;
  for (std::size_t j = 0; j < chi[0].size(); ++j) {
    WideComplex sum = 0;
    for (std::size_t k = chi.size(); k-- > 0;) sum = sum * z + chi[k][j];
    weights.push_back(sum * std::exp(Coefficient(j) * z));
  }
  WideComplex delta = 0;
  for (int i = 0; i < 40; ++i) {
    WideComplex value = residual, slope = 0;
    for (std::size_t j = 1; j < weights.size(); ++j) {
      value += weights[j] * exp_minus_one(Coefficient(j) * delta);
      slope += Coefficient(j) * weights[j] * std::exp(Coefficient(j) * delta);
    }
    const WideComplex move = value / slope;
    delta -= move;
    if (!(std::abs(delta) < 0.1L)) return std::nullopt;
    if (std::abs(move) <= 1e-14L * std::abs(delta)) return delta;
  }
  return std::nullopt;
}

}  // namespace

WideComplex value_at(const std::vector<Coefficient>& p, WideComplex z) {
  WideComplex sum = 0;
  for (std::size_t k = p.size(); k-- > 0;) sum = sum * z + p[k];
  return sum;
}

bool is_multistep(const Theory& theory) { return !theory.rho.empty() || !theory.characteristic.empty(); }

std::vector<std::vector<Coefficient>> characteristic_of(const Theory& theory) {
  if (!theory.characteristic.empty()) return theory.characteristic;
  auto rho = theory.rho, sigma = theory.sigma;
  rho.resize(std::max(rho.size(), sigma.size()), 0), sigma.resize(rho.size(), 0);
  for (auto& c : sigma) c = -c;
  return {rho, sigma};
}

std::vector<WideComplex> characteristic_at(const Theory& theory, WideComplex z) {
  const auto chi = characteristic_of(theory);
  std::vector<WideComplex> c(chi[0].size(), 0);
  for (std::size_t k = chi.size(); k-- > 0;)
    for (std::size_t j = 0; j < c.size(); ++j) c[j] = c[j] * z + chi[k][j];
  return c;
}

Coefficient largest_multistep_root(const Theory& theory, WideComplex z) {
  Coefficient largest = 0;
  for (const auto& w : polynomial_roots(characteristic_at(theory, z)))
    largest = std::max(largest, std::abs(w));
  return largest;
}

Coefficient multistep_log_amplification(const Theory& theory, WideComplex z) {
  const auto defect =
      std::abs(z) <= 0.5L ? principal_defect(characteristic_of(theory), z) : std::optional<WideComplex>();
  if (!defect) return std::log(largest_multistep_root(theory, z));
  auto roots = polynomial_roots(characteristic_at(theory, z));
  const WideComplex principal = std::exp(z + *defect);
  std::sort(roots.begin(), roots.end(), [&](const WideComplex& a, const WideComplex& b) {
    return std::abs(a - principal) < std::abs(b - principal);
  });
  Coefficient parasitic = 0;
  for (std::size_t i = 1; i < roots.size(); ++i) parasitic = std::max(parasitic, std::abs(roots[i]));
  return std::max(z.real() + defect->real(), std::log(parasitic));
}

bool zero_stable(const Theory& theory) {
  const auto rho = characteristic_of(theory)[0];
  const auto roots = polynomial_roots({rho.begin(), rho.end()});
  for (std::size_t i = 0; i < roots.size(); ++i) {
    if (std::abs(roots[i]) > 1 + 1e-7L) return false;
    if (std::abs(roots[i]) < 1 - 1e-7L) continue;
    for (std::size_t j = 0; j < i; ++j)
      if (std::abs(roots[i] - roots[j]) < 1e-6L) return false;  // a double root on the circle
  }
  return true;
}

NonNegative multistep_stable_along_ray(const Theory& theory, WideComplex direction) {
  const RealPolynomial across = eliminated(characteristic_of(theory), direction);
  std::vector<Coefficient> edges;
  Coefficient tolerance = 0;
  if (across.is_zero()) {
    edges = collisions(theory, direction);
    tolerance = 1e-10L;  // the roots stay on the circle; they are simple between collisions
  } else {
    Crossings crossings(theory, direction);
    RealPolynomial mirrored = across;
    for (std::size_t k = 1; k < mirrored.value.size(); k += 2) mirrored.value[k] = -mirrored.value[k];
    for (const Coefficient t : positive_roots(across))
      crossings.look_at(WideComplex(1, t) / WideComplex(1, -t));
    for (const Coefficient t : positive_roots(mirrored))
      crossings.look_at(WideComplex(1, -t) / WideComplex(1, t));
    crossings.look_at(1), crossings.look_at(-1);  // t = 0 and infinity
    edges = crossings.found;
  }
  std::sort(edges.begin(), edges.end());
  edges.insert(edges.begin(), 0);
  NonNegative out;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const bool last = i + 1 == edges.size();
    const Coefficient end = last ? infinity : edges[i + 1];
    if (!last && end - edges[i] <= 1e-15L * end) continue;  // the same crossing found twice
    const Coefficient middle = last ? 2 * edges[i] + 1 : (edges[i] + end) / 2;
    if (!(multistep_log_amplification(theory, middle * direction) <= tolerance)) continue;
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
