// Continued fractions: the convergents of a rounded quotient come back to the quotient.
#include "integrators/fractions.hpp"

#include <cmath>

namespace odemark {

std::optional<Fraction> simplest_fraction(Coefficient x) {
  constexpr Coefficient largest = 0x1p31L;
  const Coefficient size = std::abs(x);
  if (!(size < largest)) return std::nullopt;
  Coefficient rest = size, before_p = 1, before_q = 0, p = std::floor(rest), q = 1;
  for (int i = 0; i < 64; ++i) {
    if (p / q == size)
      return Fraction{static_cast<std::int64_t>(x < 0 ? -p : p), static_cast<std::int64_t>(q)};
    const Coefficient fraction = rest - std::floor(rest);
    if (fraction == 0) return std::nullopt;
    rest = 1 / fraction;
    const Coefficient digit = std::floor(rest);
    const Coefficient next_p = digit * p + before_p, next_q = digit * q + before_q;
    before_p = p, before_q = q, p = next_p, q = next_q;
    if (!(p < largest && q < largest)) return std::nullopt;
  }
  return std::nullopt;
}

}  // namespace odemark
