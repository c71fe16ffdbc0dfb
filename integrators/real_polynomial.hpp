// Real polynomials that know how far their coefficients can be trusted, and where they are not negative.
#pragma once

#include <limits>
#include <utility>
#include <vector>

#include "integrators/stepper.hpp"

namespace odemark {

namespace detail {
inline constexpr Coefficient infinity = std::numeric_limits<Coefficient>::infinity();
inline constexpr Coefficient spacing = std::numeric_limits<Coefficient>::epsilon();  // of numbers above 1
}  // namespace detail

/// Disjoint closed intervals of [0, infinity], ascending, none of length 0.
using Intervals = std::vector<std::pair<Coefficient, Coefficient>>;

Intervals intersection(const Intervals& a, const Intervals& b);

/// Ascending powers. `magnitude` is the sum of the absolute values of the terms that a coefficient was summed
/// from: a coefficient far below it is what rounding left of a zero, and must not decide a sign.
struct RealPolynomial {
  std::vector<Coefficient> value, magnitude;

  RealPolynomial() = default;
  explicit RealPolynomial(std::vector<Coefficient> coefficients);

  void add_term(std::size_t power, Coefficient term);
  /// Sets coefficients that are rounding noise to exactly 0 and drops zeros at the top.
  void clean(Coefficient tolerance = 1e-14L);
  bool is_zero() const;
  Coefficient operator()(Coefficient x) const;
};

RealPolynomial operator+(const RealPolynomial& a, const RealPolynomial& b);
RealPolynomial operator-(const RealPolynomial& a, const RealPolynomial& b);
RealPolynomial operator*(const RealPolynomial& a, const RealPolynomial& b);

/// All x > 0 with p(x) = 0, ascending; a root touched without crossing counts once. p must be clean.
std::vector<Coefficient> positive_roots(const RealPolynomial& p);

struct NonNegative {
  Intervals where;                   // p(x) >= 0
  std::vector<Coefficient> touches;  // p(x) = 0 inside `where`, without a change of sign
};

/// Where a clean p is not negative on [0, infinity]. Everywhere, if p is zero.
NonNegative where_not_negative(const RealPolynomial& p);

}  // namespace odemark
