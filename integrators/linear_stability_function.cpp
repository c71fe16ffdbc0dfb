// Stability functions R = P / Q along a ray: the sign of |Q|^2 - |P|^2 decides.
#include <algorithm>
#include <cmath>

#include "integrators/linear_stability_parts.hpp"

namespace odemark {

int linear_order(const Theory& theory) {
  const auto &p = theory.numerator, &q = theory.denominator;
  for (std::size_t n = 0; n <= p.size() + q.size(); ++n) {
    Coefficient sum = n < p.size() ? -p[n] : 0, size = std::abs(sum), factorial = 1;
    for (std::size_t k = 0; k <= n; factorial *= Coefficient(++k))  // term of q_(n-k) z^k / k!
      if (n - k < q.size()) sum += q[n - k] / factorial, size += std::abs(q[n - k]) / factorial;
    // loose, because a coefficient may have been typed or probed in double; no real error constant is so
    // small
    if (!(std::abs(sum) <= 1e-8L * size)) return int(n) - 1;
  }
  return int(p.size() + q.size());
}

namespace detail {

namespace {

/// |p(r direction)|^2 as a polynomial in r; `powers` holds direction^k.
RealPolynomial squared_modulus(const std::vector<Coefficient>& p, const std::vector<WideComplex>& powers) {
  RealPolynomial out;
  for (std::size_t j = 0; j < p.size(); ++j)
    for (std::size_t k = 0; k < p.size(); ++k)
      out.add_term(j + k, p[j] * p[k] * powers[j > k ? j - k : k - j].real());
  return out;
}

/// A top coefficient far below that of the denominator is a zero in decimals: it would rule at infinity.
std::vector<Coefficient> trimmed(std::vector<Coefficient> p, const std::vector<Coefficient>& q) {
  while (p.size() > 1 && p.size() <= q.size() && std::abs(p.back()) <= 1e-9L * std::abs(q[p.size() - 1]))
    p.pop_back();
  return p;
}

}  // namespace

RealPolynomial boundary_polynomial(const Theory& theory, WideComplex direction) {
  const auto& q = theory.denominator;
  const auto p = trimmed(theory.numerator, q);
  std::vector<WideComplex> powers{1};
  while (powers.size() < std::max(p.size(), q.size())) powers.push_back(powers.back() * direction);
  RealPolynomial out = squared_modulus(q, powers) - squared_modulus(p, powers);
  // On the imaginary axis |e^z| = 1, so |R|^2 = 1 + O(r^(order+1)): the lower powers are zero, whatever the
  // digits of the coefficients say. Without this, rounding decides whether a method is stable there at all.
  if (direction.real() == 0)
    for (std::size_t n = 0; n < out.value.size() && int(n) <= linear_order(theory); ++n) out.value[n] = 0;
  out.clean();
  return out;
}

namespace {

Intervals joined(Intervals a, const Intervals& b) {
  a.insert(a.end(), b.begin(), b.end());
  std::sort(a.begin(), a.end());
  Intervals out;
  for (const auto& [low, high] : a)
    if (!out.empty() && low <= out.back().second)
      out.back().second = std::max(out.back().second, high);
    else
      out.emplace_back(low, high);
  return out;
}

/// On the real axis Q^2 - P^2 = (Q - P)(Q + P): factors of half the degree, which keeps twice the digits of
/// the long intervals of stabilised methods.
NonNegative stable_on_real_axis(const Theory& theory, Coefficient sign) {
  const auto& q = theory.denominator;
  const auto p = trimmed(theory.numerator, q);
  RealPolynomial minus, plus;
  Coefficient power = 1;
  for (std::size_t k = 0; k < std::max(p.size(), q.size()); ++k, power *= sign) {
    const Coefficient a = k < q.size() ? power * q[k] : 0, b = k < p.size() ? power * p[k] : 0;
    minus.add_term(k, a), minus.add_term(k, -b), plus.add_term(k, a), plus.add_term(k, b);
  }
  minus.clean(), plus.clean();
  const auto negated = [](const RealPolynomial& f) { return RealPolynomial({-1}) * f; };
  const auto a = where_not_negative(minus), b = where_not_negative(plus),
             c = where_not_negative(negated(minus)), d = where_not_negative(negated(plus));
  NonNegative out{joined(intersection(a.where, b.where), intersection(c.where, d.where)), a.touches};
  for (const auto* more : {&b, &c, &d})
    out.touches.insert(out.touches.end(), more->touches.begin(), more->touches.end());
  return out;
}

}  // namespace

NonNegative stable_along_ray(const Theory& theory, WideComplex direction) {
  if (direction.imag() == 0) return stable_on_real_axis(theory, direction.real());
  return where_not_negative(boundary_polynomial(theory, direction));
}

Coefficient log_amplification(const Theory& theory, WideComplex z) {
  const Coefficient r = std::abs(z);
  if (r == 0) return 0;
  Coefficient q2 = 0;
  WideComplex q = 0;
  for (std::size_t k = theory.denominator.size(); k-- > 0;) q = q * z + theory.denominator[k];
  q2 = std::norm(q);
  const Coefficient deficit = boundary_polynomial(theory, z / r)(r) / q2;  // 1 - |R|^2
  if (deficit < 0.5L) return std::log1p(-deficit) / 2;
  return std::log(amplification(theory, z));
}

}  // namespace detail

}  // namespace odemark
