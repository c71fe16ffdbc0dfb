// The series of ln w(z) for the root w of the step that approximates e^z, and what it says of oscillations.
#include <algorithm>
#include <cmath>

#include "integrators/facts_parts.hpp"
#include "integrators/linear_stability_parts.hpp"

namespace odemark::detail {

namespace {

constexpr std::size_t terms = 40;

/// A truncated power series with the rounding scale of every coefficient.
struct Series {
  std::vector<Coefficient> value = std::vector<Coefficient>(terms, 0), size = value;
};

/// ln of a series that begins with a nonzero number; that number's own logarithm is left out.
Series logarithm(const std::vector<Coefficient>& p) {
  Series out;
  const auto at = [&](std::size_t k) { return k < p.size() ? p[k] / p[0] : 0; };
  for (std::size_t n = 1; n < terms; ++n) {  // n p_n = sum k l_k p_(n-k)
    out.value[n] = at(n), out.size[n] = std::abs(at(n));
    for (std::size_t k = 1; k < n; ++k) {
      const Coefficient part = Coefficient(k) / Coefficient(n);
      out.value[n] -= part * out.value[k] * at(n - k);
      out.size[n] += part * out.size[k] * std::abs(at(n - k));
    }
  }
  return out;
}

/// ln(R e^-z) = ln(1 + (P - Q e^z) e^-z / Q), where P - Q e^z begins at z^(order+1): what cancels is never
/// formed.
Series logarithm_of_ratio(const Theory& theory, int order) {
  const auto &p = theory.numerator, &q = theory.denominator;
  std::vector<Coefficient> inverse(terms, 0), difference(terms, 0), deviation(terms, 0);
  Coefficient factorial = 1;
  std::vector<Coefficient> exponential(terms, 0);  // of e^z
  for (std::size_t n = 0; n < terms; factorial *= Coefficient(++n)) exponential[n] = 1 / factorial;
  for (std::size_t n = 0; n < terms; ++n) {  // e^-z / Q
    inverse[n] = exponential[n] * (n % 2 ? -1 : 1);
    for (std::size_t k = 1; k < q.size() && k <= n; ++k) inverse[n] -= q[k] * inverse[n - k];
    inverse[n] /= q[0];
  }
  Series out;
  for (std::size_t n = std::size_t(order) + 1; n < terms; ++n) {
    difference[n] = n < p.size() ? p[n] : 0;
    for (std::size_t k = 0; k <= n && k < q.size(); ++k) difference[n] -= q[k] * exponential[n - k];
  }
  std::vector<Coefficient> size(terms, 0);
  for (std::size_t n = 0; n < terms; ++n)
    for (std::size_t k = 0; k <= n; ++k) {
      deviation[n] += difference[k] * inverse[n - k];
      size[n] += std::abs(difference[k] * inverse[n - k]);
    }
  deviation[0] = 1;
  out = logarithm(deviation);
  for (std::size_t n = 0; n < terms; ++n) out.size[n] = std::max(out.size[n], size[n]);
  return out;
}

/// ln w of the root with w(0) = 1: with w = e^z (1 + d) the characteristic polynomial fixes d term by term,
/// because its derivative in w at (0, 1) is rho'(1), not 0.
Series multistep_logarithm(const Theory& theory) {
  const auto c = characteristic_of(theory);
  Coefficient slope = 0;
  for (std::size_t j = 0; j < c[0].size(); ++j) slope += Coefficient(j) * c[0][j];
  Series l;                                           // ln w, found coefficient by coefficient
  const auto exponential = [&](Coefficient factor) {  // e^(factor l)
    Series e;
    e.value[0] = e.size[0] = 1;
    for (std::size_t n = 1; n < terms; ++n)
      for (std::size_t k = 1; k <= n; ++k) {
        const Coefficient part = Coefficient(k) / Coefficient(n) * factor;
        e.value[n] += part * l.value[k] * e.value[n - k];
        e.size[n] += std::abs(part * l.value[k]) * e.size[n - k];
      }
    return e;
  };
  constexpr std::size_t wanted = 20;  // orders of multistep methods end far below
  for (std::size_t n = 1; n < wanted; ++n) {
    Coefficient residual = 0, size = 0;
    for (std::size_t j = 0; j < c[0].size() || j < c.back().size(); ++j) {
      const Series power = exponential(Coefficient(j));
      for (std::size_t k = 0; k < c.size() && k <= n; ++k)
        if (j < c[k].size()) {
          residual += c[k][j] * power.value[n - k];
          size += std::abs(c[k][j]) * power.size[n - k];
        }
    }
    l.value[n] = -residual / slope, l.size[n] = size / std::abs(slope);
  }
  l.value.resize(wanted), l.size.resize(wanted);
  l.value[1] -= 1;  // what is asked for is ln(w e^-z)
  return l;
}

Fact<PowerLaw> first_term(const Series& l, bool even, int from) {
  for (std::size_t n = std::size_t(from); n < l.value.size(); ++n) {
    if ((n % 2 == 0) != even) continue;
    Coefficient value = l.value[n] - (n == 1 ? 1 : 0);
    // the digits of a typed coefficient are good for 1e-15 or better; no real error constant is so small
    if (!(std::abs(value) > 1e-11L * l.size[n])) continue;
    // i^n, or i^(n-1) of the odd ones, whose i is that of arg
    const bool turned = (even ? n / 2 : (n - 1) / 2) % 2 == 1;
    return PowerLaw{turned ? -value : value, int(n)};
  }
  return Fact<PowerLaw>::none(even ? "amplitudes of oscillations are kept"
                                   : "phases of oscillations are kept");
}

}  // namespace

PrincipalRoot principal_root(const Theory& theory) {
  Series l;
  PrincipalRoot out;
  if (is_one_step_function(theory)) {
    out.order = linear_order(theory);
    l = logarithm_of_ratio(theory, out.order);
  } else {
    l = multistep_logarithm(theory);
    while (std::size_t(out.order) + 1 < l.value.size() &&
           std::abs(l.value[std::size_t(out.order) + 1]) <= 1e-11L * l.size[std::size_t(out.order) + 1])
      ++out.order;
  }
  if (std::size_t(out.order) + 1 < l.value.size()) out.error = l.value[std::size_t(out.order) + 1];
  out.log_amplification = first_term(l, true, out.order + 1);
  out.phase_error = first_term(l, false, out.order + 1);
  return out;
}

}  // namespace odemark::detail
