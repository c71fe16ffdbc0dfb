// Powers good enough for a step size: three to four times faster than std::pow, the same bits everywhere.
#pragma once

#include <bit>
#include <cstdint>

namespace odemark {

/// x^p for a normal x > 0 and |p log2 x| < 1000, to a relative error of about 1e-5 where |p log2 x| is below
/// 8: log2 and exp2 by range reduction and short series, additions and products only.
constexpr double quick_power(double x, double p) {
  constexpr std::uint64_t fraction_bits = (std::uint64_t(1) << 52) - 1;
  const std::uint64_t bits = std::bit_cast<std::uint64_t>(x);
  double exponent = static_cast<double>(static_cast<std::int64_t>(bits >> 52) - 1023);
  double m = std::bit_cast<double>((bits & fraction_bits) | (std::uint64_t(1023) << 52));
  if (m > 1.4142135623730951) m *= 0.5, exponent += 1;
  // log2 m = 2 / ln 2 artanh s
  const double s = (m - 1) / (m + 1), s2 = s * s;
  const double power =
      p * (exponent + s * (2.885390081777927 + s2 * (0.961796693925976 + s2 * 0.577078016355585)));
  const double whole = static_cast<double>(static_cast<std::int64_t>(power + (power < 0 ? -0.5 : 0.5)));
  const double z = (power - whole) * 0.693147180559945309;  // |z| <= 0.35
  const double e = 1 + z * (1 + z * (1. / 2 + z * (1. / 6 + z * (1. / 24 + z * (1. / 120)))));
  return e * std::bit_cast<double>(static_cast<std::uint64_t>(static_cast<std::int64_t>(whole) + 1023) << 52);
}

}  // namespace odemark
