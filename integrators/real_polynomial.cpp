// Real polynomials: arithmetic with magnitudes, roots between the roots of the derivative, signs in between.
#include "integrators/real_polynomial.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace odemark {

namespace {

/// -1, 0 or 1; 0 where the value drowns in the rounding of its own evaluation.
int sign_at(const std::vector<Coefficient>& p, Coefficient x) {
  Coefficient sum = 0, size = 0;
  for (std::size_t k = p.size(); k-- > 0;) sum = sum * x + p[k], size = size * x + std::abs(p[k]);
  if (std::abs(sum) <= 4 * Coefficient(p.size()) * detail::spacing * size) return 0;
  return sum > 0 ? 1 : -1;
}

Coefficient bisect(const std::vector<Coefficient>& p, Coefficient low, Coefficient high, int sign_low) {
  for (int i = 0; i < 200; ++i) {
    const Coefficient middle = low + (high - low) / 2;
    if (!(middle > low && middle < high)) break;
    const int sign = sign_at(p, middle);
    if (sign == 0) return middle;
    (sign == sign_low ? low : high) = middle;
  }
  return low + (high - low) / 2;
}

/// Roots in (0, 1) of a polynomial with p(0) != 0. Between two critical points it is monotone, so a change of
/// sign there is one root and no change is none; a double root is a critical point with the value 0.
std::vector<Coefficient> roots_in_unit_interval(const std::vector<Coefficient>& p) {
  if (p.size() < 2) return {};
  std::vector<Coefficient> slope(p.size() - 1);
  for (std::size_t k = 1; k < p.size(); ++k) slope[k - 1] = Coefficient(k) * p[k];
  while (slope.size() > 1 && slope.front() == 0) slope.erase(slope.begin());  // a root at 0 bounds nothing
  std::vector<Coefficient> points = roots_in_unit_interval(slope), roots;
  points.insert(points.begin(), 0);
  points.push_back(1);
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const int left = sign_at(p, points[i]), right = sign_at(p, points[i + 1]);
    if (left * right < 0) roots.push_back(bisect(p, points[i], points[i + 1], left));
    if (right == 0 && (roots.empty() || points[i + 1] > roots.back())) roots.push_back(points[i + 1]);
  }
  return roots;
}

}  // namespace

Intervals intersection(const Intervals& a, const Intervals& b) {
  Intervals out;
  for (const auto& [a0, a1] : a)
    for (const auto& [b0, b1] : b) {
      const Coefficient low = std::max(a0, b0), high = std::min(a1, b1);
      if (high > low) out.emplace_back(low, high);
    }
  std::sort(out.begin(), out.end());
  return out;
}

RealPolynomial::RealPolynomial(std::vector<Coefficient> coefficients) : value(std::move(coefficients)) {
  for (const Coefficient c : value) magnitude.push_back(std::abs(c));
}

void RealPolynomial::add_term(std::size_t power, Coefficient term) {
  if (value.size() <= power) value.resize(power + 1, 0), magnitude.resize(power + 1, 0);
  value[power] += term, magnitude[power] += std::abs(term);
}

void RealPolynomial::clean(Coefficient tolerance) {
  for (std::size_t k = 0; k < value.size(); ++k)
    if (std::abs(value[k]) <= tolerance * magnitude[k]) value[k] = 0;
  while (!value.empty() && value.back() == 0) value.pop_back(), magnitude.pop_back();
}

bool RealPolynomial::is_zero() const {
  return std::all_of(value.begin(), value.end(), [](Coefficient c) { return c == 0; });
}

Coefficient RealPolynomial::operator()(Coefficient x) const {
  Coefficient sum = 0;
  for (std::size_t k = value.size(); k-- > 0;) sum = sum * x + value[k];
  return sum;
}

static RealPolynomial combined(const RealPolynomial& a, const RealPolynomial& b, Coefficient sign) {
  RealPolynomial out = a;
  out.value.resize(std::max(a.value.size(), b.value.size()), 0);
  out.magnitude.resize(out.value.size(), 0);
  for (std::size_t k = 0; k < b.value.size(); ++k)
    out.value[k] += sign * b.value[k], out.magnitude[k] += b.magnitude[k];
  return out;
}

RealPolynomial operator+(const RealPolynomial& a, const RealPolynomial& b) { return combined(a, b, 1); }
RealPolynomial operator-(const RealPolynomial& a, const RealPolynomial& b) { return combined(a, b, -1); }

RealPolynomial operator*(const RealPolynomial& a, const RealPolynomial& b) {
  RealPolynomial out;
  if (a.value.empty() || b.value.empty()) return out;
  out.value.assign(a.value.size() + b.value.size() - 1, 0);
  out.magnitude = out.value;
  for (std::size_t i = 0; i < a.value.size(); ++i)
    for (std::size_t j = 0; j < b.value.size(); ++j) {
      out.value[i + j] += a.value[i] * b.value[j];
      out.magnitude[i + j] += a.magnitude[i] * b.magnitude[j];
    }
  return out;
}

std::vector<Coefficient> positive_roots(const RealPolynomial& p) {
  const auto first = std::find_if(p.value.begin(), p.value.end(), [](Coefficient c) { return c != 0; });
  std::vector<Coefficient> c(first, p.value.end());
  if (c.size() < 2) return {};
  Coefficient bound = 0;  // Fujiwara: no root is larger than this
  for (std::size_t k = 0; k + 1 < c.size(); ++k)
    if (c[k] != 0)
      bound = std::max(bound, 2 * std::pow(std::abs(c[k] / c.back()), 1 / Coefficient(c.size() - 1 - k)));
  bound *= 1.01L;
  Coefficient power = 1;
  for (auto& coefficient : c) coefficient *= power, power *= bound;
  auto roots = roots_in_unit_interval(c);
  for (auto& root : roots) root *= bound;
  return roots;
}

NonNegative where_not_negative(const RealPolynomial& p) {
  NonNegative out;
  if (p.is_zero()) {
    out.where = {{0, detail::infinity}};
    return out;
  }
  auto edges = positive_roots(p);
  edges.insert(edges.begin(), 0);
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const bool last = i + 1 == edges.size();
    const Coefficient middle = last ? 2 * edges[i] + 1 : (edges[i] + edges[i + 1]) / 2;
    if (!(p(middle) >= 0)) continue;
    const Coefficient end = last ? detail::infinity : edges[i + 1];
    if (!out.where.empty() && out.where.back().second == edges[i]) {
      out.touches.push_back(edges[i]);
      out.where.back().second = end;
    } else {
      out.where.emplace_back(edges[i], end);
    }
  }
  return out;
}

}  // namespace odemark
