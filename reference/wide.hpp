// Fifty-digit numbers, with their arithmetic compiled once: a family costs its declarations and nothing more.
#pragma once

#include <compare>
#include <concepts>
#include <cstddef>
#include <ios>
#include <limits>
#include <string>

namespace odemark {

/// A binary floating-point number of 168 bits: Boost's cpp_bin_float<50>, header-only, no LGPL, the same bits
/// everywhere. Its arithmetic takes a hundred nanoseconds an operation, so that the call costs nothing.
class Wide {
 public:
  Wide() noexcept;
  Wide(const Wide&) noexcept;
  Wide& operator=(const Wide&) noexcept;
  ~Wide() = default;
  template <std::signed_integral I>
  Wide(I value) noexcept : Wide(From{}, static_cast<long long>(value)) {}
  template <std::unsigned_integral I>
  Wide(I value) noexcept : Wide(From{}, static_cast<unsigned long long>(value)) {}
  Wide(float value) noexcept : Wide(static_cast<long double>(value)) {}
  Wide(double value) noexcept : Wide(static_cast<long double>(value)) {}
  Wide(long double value) noexcept;
  /// A decimal number; throws std::runtime_error for any other text.
  explicit Wide(const std::string& text);
  explicit Wide(const char* text) : Wide(std::string(text)) {}

  explicit operator float() const noexcept { return static_cast<float>(static_cast<double>(*this)); }
  explicit operator double() const noexcept;  // nearest
  explicit operator long double() const noexcept;
  explicit operator int() const noexcept;
  explicit operator long() const noexcept;
  /// As std::ostream would write it with that precision and those flags.
  std::string str(std::streamsize digits = 0, std::ios_base::fmtflags flags = {}) const;

  Wide& operator+=(const Wide&) noexcept;
  Wide& operator-=(const Wide&) noexcept;
  Wide& operator*=(const Wide&) noexcept;
  Wide& operator/=(const Wide&) noexcept;
  Wide operator+() const noexcept { return *this; }
  Wide operator-() const noexcept;
  friend Wide operator+(const Wide&, const Wide&) noexcept;
  friend Wide operator-(const Wide&, const Wide&) noexcept;
  friend Wide operator*(const Wide&, const Wide&) noexcept;
  friend Wide operator/(const Wide&, const Wide&) noexcept;
  friend bool operator==(const Wide&, const Wide&) noexcept;
  friend std::partial_ordering operator<=>(const Wide&, const Wide&) noexcept;

  struct Access;  // the number inside, for wide.cpp

 private:
  struct From {};
  Wide(From, long long value) noexcept;
  Wide(From, unsigned long long value) noexcept;
  alignas(16) std::byte number_[64];
};

#define ODEMARK_WIDE_FUNCTION(name) Wide name(const Wide&);
ODEMARK_WIDE_FUNCTION(abs)
ODEMARK_WIDE_FUNCTION(sqrt)
ODEMARK_WIDE_FUNCTION(cbrt)
ODEMARK_WIDE_FUNCTION(exp)
ODEMARK_WIDE_FUNCTION(expm1)
ODEMARK_WIDE_FUNCTION(log)
ODEMARK_WIDE_FUNCTION(log1p)
ODEMARK_WIDE_FUNCTION(sin)
ODEMARK_WIDE_FUNCTION(cos)
ODEMARK_WIDE_FUNCTION(tan)
ODEMARK_WIDE_FUNCTION(asin)
ODEMARK_WIDE_FUNCTION(acos)
ODEMARK_WIDE_FUNCTION(atan)
ODEMARK_WIDE_FUNCTION(sinh)
ODEMARK_WIDE_FUNCTION(cosh)
ODEMARK_WIDE_FUNCTION(tanh)
ODEMARK_WIDE_FUNCTION(asinh)
ODEMARK_WIDE_FUNCTION(acosh)
ODEMARK_WIDE_FUNCTION(atanh)
ODEMARK_WIDE_FUNCTION(floor)
ODEMARK_WIDE_FUNCTION(ceil)
ODEMARK_WIDE_FUNCTION(round)
ODEMARK_WIDE_FUNCTION(trunc)
#undef ODEMARK_WIDE_FUNCTION
Wide atan2(const Wide& y, const Wide& x);
Wide pow(const Wide& base, const Wide& exponent);
Wide fmod(const Wide&, const Wide&);
Wide hypot(const Wide&, const Wide&);
Wide copysign(const Wide& size, const Wide& sign);
Wide ldexp(const Wide&, int exponent);
Wide frexp(const Wide&, int* exponent);
bool isfinite(const Wide&);
bool isnan(const Wide&);
bool isinf(const Wide&);
bool signbit(const Wide&);

}  // namespace odemark

template <>
struct std::numeric_limits<odemark::Wide> {
  static constexpr bool is_specialized = true, is_signed = true, is_integer = false, is_exact = false,
                        has_infinity = true, has_quiet_NaN = true, is_iec559 = false, is_bounded = true;
  static constexpr int radix = 2, digits = 168, digits10 = 50, max_digits10 = 53;
  static odemark::Wide epsilon();
  static odemark::Wide min();
  static odemark::Wide max();
  static odemark::Wide lowest();
  static odemark::Wide infinity();
  static odemark::Wide quiet_NaN();
};
