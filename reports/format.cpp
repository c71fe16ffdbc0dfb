// Numbers as people read them. What is not finite prints as the dash no_value, never as "nan".
#include "reports/format.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

namespace odemark {
namespace {

// The decimal exponent after rounding to the digits shown: 9.996 with three digits is 10.0, exponent 1.
int rounded_exponent(double x, int digits) {
  const std::string text = fmt::format("{:.{}e}", x, std::max(digits, 1) - 1);
  return std::atoi(text.c_str() + text.find('e') + 1);
}

std::string fixed(double x, int decimals) { return fmt::format("{:.{}f}", x, std::max(decimals, 0)); }

}  // namespace

std::string scientific(double x, int digits) {
  if (!std::isfinite(x)) return std::string(no_value);
  if (x == 0) return "0";
  return fmt::format("{:.{}e}", x, std::max(digits, 1) - 1);
}

std::string engineering(double x, int digits) {
  if (!std::isfinite(x)) return std::string(no_value);
  if (x == 0) return "0";
  const int exponent = rounded_exponent(x, digits);
  const int thousands = static_cast<int>(std::floor(exponent / 3.0)) * 3;
  // Splitting the printed digits, not dividing by a power of ten, keeps the rounding of the number itself.
  const std::string printed = fmt::format("{:.{}e}", x, std::max(digits, 1) - 1);
  const double mantissa = std::strtod(printed.substr(0, printed.find('e')).c_str(), nullptr);
  const double shifted = mantissa * std::pow(10.0, exponent - thousands);
  return fmt::format("{}e{}{:02}", fixed(shifted, digits - 1 - (exponent - thousands)),
                     thousands < 0 ? '-' : '+', std::abs(thousands));
}

std::string significant(double x, int digits) {
  if (!std::isfinite(x)) return std::string(no_value);
  if (x == 0) return "0";
  const int exponent = rounded_exponent(x, digits);
  if (exponent < -4 || exponent >= 6) return scientific(x, digits);
  return fixed(x, digits - 1 - exponent);
}

std::string compact(double x, int digits) {
  if (!std::isfinite(x)) return std::string(no_value);
  return fmt::format("{:.{}g}", x == 0 ? 0.0 : x, std::max(digits, 1));
}

std::string percent(double fraction, int digits) {
  if (!std::isfinite(fraction)) return std::string(no_value);
  return fixed(fraction * 100, digits) + " %";
}

std::string duration(double seconds, int digits) {
  struct Unit {
    double size;
    const char* name;
  };
  constexpr std::array units{Unit{1, "s"}, Unit{1e-3, "ms"}, Unit{1e-6, "µs"}, Unit{1e-9, "ns"}};
  if (!std::isfinite(seconds)) return std::string(no_value);
  if (seconds == 0) return "0 s";
  for (const Unit& unit : units) {
    const double amount = seconds / unit.size;
    const int exponent = rounded_exponent(amount, digits);
    if (exponent >= 0 || unit.size == units.back().size)
      return fixed(amount, std::min(digits - 1 - exponent, 6)) + ' ' + unit.name;
  }
  return std::string(no_value);
}

std::string power_of_ten(int exponent) {
  constexpr std::array digits{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string out = exponent < 0 ? "10⁻" : "10";
  for (const char c : std::to_string(std::abs(exponent))) out += digits[static_cast<std::size_t>(c - '0')];
  return out;
}

std::string within_resolution(double x, double resolution, int digits) {
  if (!std::isfinite(x) || !std::isfinite(resolution)) return std::string(no_value);
  if (std::abs(x) <= resolution) return fmt::format("0 within {}", scientific(resolution, 1));
  return significant(x, digits);
}

}  // namespace odemark
