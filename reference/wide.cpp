#include "reference/wide.hpp"

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <new>

namespace odemark {

namespace {
using Number =
    boost::multiprecision::number<boost::multiprecision::cpp_bin_float<50>, boost::multiprecision::et_off>;
using Limits = std::numeric_limits<Number>;
}  // namespace

struct Wide::Access {
  static const Number& of(const Wide& x) { return *std::launder(reinterpret_cast<const Number*>(x.number_)); }
  static Number& of(Wide& x) { return *std::launder(reinterpret_cast<Number*>(x.number_)); }
  template <class... From>
  static void make(Wide& x, const From&... from) {
    static_assert(sizeof(Number) <= sizeof(x.number_) && alignof(Number) <= alignof(Wide));
    static_assert(std::is_trivially_destructible_v<Number>);
    ::new (static_cast<void*>(x.number_)) Number(from...);
  }
};

namespace {
const Number& n(const Wide& x) { return Wide::Access::of(x); }
Number& n(Wide& x) { return Wide::Access::of(x); }
Wide wide(const Number& x) {
  Wide out;
  n(out) = x;
  return out;
}
}  // namespace

Wide::Wide() noexcept { Access::make(*this); }
Wide::Wide(const Wide& other) noexcept { Access::make(*this, n(other)); }
Wide& Wide::operator=(const Wide& other) noexcept {
  n(*this) = n(other);
  return *this;
}
Wide::Wide(From, long long value) noexcept { Access::make(*this, value); }
Wide::Wide(From, unsigned long long value) noexcept { Access::make(*this, value); }
Wide::Wide(long double value) noexcept { Access::make(*this, value); }
Wide::Wide(const std::string& text) { Access::make(*this, text); }

Wide::operator double() const noexcept { return static_cast<double>(n(*this)); }
Wide::operator long double() const noexcept { return static_cast<long double>(n(*this)); }
Wide::operator int() const noexcept { return static_cast<int>(n(*this)); }
Wide::operator long() const noexcept { return static_cast<long>(n(*this)); }
std::string Wide::str(std::streamsize digits, std::ios_base::fmtflags flags) const {
  return n(*this).str(digits, flags);
}

Wide& Wide::operator+=(const Wide& o) noexcept {
  n(*this) += n(o);
  return *this;
}
Wide& Wide::operator-=(const Wide& o) noexcept {
  n(*this) -= n(o);
  return *this;
}
Wide& Wide::operator*=(const Wide& o) noexcept {
  n(*this) *= n(o);
  return *this;
}
Wide& Wide::operator/=(const Wide& o) noexcept {
  n(*this) /= n(o);
  return *this;
}
Wide Wide::operator-() const noexcept { return wide(-n(*this)); }
Wide operator+(const Wide& a, const Wide& b) noexcept { return wide(n(a) + n(b)); }
Wide operator-(const Wide& a, const Wide& b) noexcept { return wide(n(a) - n(b)); }
Wide operator*(const Wide& a, const Wide& b) noexcept { return wide(n(a) * n(b)); }
Wide operator/(const Wide& a, const Wide& b) noexcept { return wide(n(a) / n(b)); }
bool operator==(const Wide& a, const Wide& b) noexcept { return n(a) == n(b); }
std::partial_ordering operator<=>(const Wide& a, const Wide& b) noexcept {
  if (n(a) < n(b)) return std::partial_ordering::less;
  if (n(a) > n(b)) return std::partial_ordering::greater;
  return n(a) == n(b) ? std::partial_ordering::equivalent : std::partial_ordering::unordered;
}

#define ODEMARK_WIDE_FUNCTION(name) \
  Wide name(const Wide& x) { return wide(name(n(x))); }
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
Wide atan2(const Wide& y, const Wide& x) { return wide(atan2(n(y), n(x))); }
Wide pow(const Wide& base, const Wide& exponent) { return wide(pow(n(base), n(exponent))); }
Wide fmod(const Wide& a, const Wide& b) { return wide(fmod(n(a), n(b))); }
Wide hypot(const Wide& a, const Wide& b) { return wide(sqrt(n(a) * n(a) + n(b) * n(b))); }
Wide copysign(const Wide& size, const Wide& sign) { return signbit(size) == signbit(sign) ? size : -size; }
Wide ldexp(const Wide& x, int exponent) { return wide(ldexp(n(x), exponent)); }
Wide frexp(const Wide& x, int* exponent) { return wide(frexp(n(x), exponent)); }
bool isfinite(const Wide& x) { return (boost::multiprecision::isfinite)(n(x)); }
bool isnan(const Wide& x) { return (boost::multiprecision::isnan)(n(x)); }
bool isinf(const Wide& x) { return (boost::multiprecision::isinf)(n(x)); }
bool signbit(const Wide& x) { return (boost::multiprecision::signbit)(n(x)) != 0; }

}  // namespace odemark

using odemark::Limits;
using odemark::Wide;
Wide std::numeric_limits<Wide>::epsilon() { return odemark::wide(Limits::epsilon()); }
Wide std::numeric_limits<Wide>::min() { return odemark::wide((Limits::min)()); }
Wide std::numeric_limits<Wide>::max() { return odemark::wide((Limits::max)()); }
Wide std::numeric_limits<Wide>::lowest() { return odemark::wide(Limits::lowest()); }
Wide std::numeric_limits<Wide>::infinity() { return odemark::wide(Limits::infinity()); }
Wide std::numeric_limits<Wide>::quiet_NaN() { return odemark::wide(Limits::quiet_NaN()); }
