// A float that cannot become anything else: what compiles with it stays in float.
#pragma once

#include <cmath>
#include <limits>

namespace odemark {

/// Made from constants of any type on purpose, never convertible back. Every operation rounds to float.
struct StrictFloat {
  float value = 0;

  StrictFloat() = default;
  constexpr StrictFloat(int whole) : value(static_cast<float>(whole)) {}
  template <class U>
  requires std::is_arithmetic_v<U>
  constexpr explicit StrictFloat(U constant) : value(static_cast<float>(constant)) {}

  StrictFloat operator-() const { return StrictFloat(-value); }
  StrictFloat& operator+=(StrictFloat o) { return *this = *this + o; }
  StrictFloat& operator-=(StrictFloat o) { return *this = *this - o; }
  StrictFloat& operator*=(StrictFloat o) { return *this = *this * o; }
  StrictFloat& operator/=(StrictFloat o) { return *this = *this / o; }
  friend StrictFloat operator+(StrictFloat a, StrictFloat b) {
    return StrictFloat(rounded(a.value + b.value));
  }
  friend StrictFloat operator-(StrictFloat a, StrictFloat b) {
    return StrictFloat(rounded(a.value - b.value));
  }
  friend StrictFloat operator*(StrictFloat a, StrictFloat b) {
    return StrictFloat(rounded(a.value * b.value));
  }
  friend StrictFloat operator/(StrictFloat a, StrictFloat b) {
    return StrictFloat(rounded(a.value / b.value));
  }
  friend bool operator<(StrictFloat a, StrictFloat b) { return a.value < b.value; }
  friend bool operator==(StrictFloat a, StrictFloat b) { return a.value == b.value; }
  friend StrictFloat sqrt(StrictFloat x) { return StrictFloat(std::sqrt(x.value)); }
  friend StrictFloat exp(StrictFloat x) { return StrictFloat(std::exp(x.value)); }
  friend StrictFloat log(StrictFloat x) { return StrictFloat(std::log(x.value)); }
  friend StrictFloat atan(StrictFloat x) { return StrictFloat(std::atan(x.value)); }
  friend StrictFloat sinh(StrictFloat x) { return StrictFloat(std::sinh(x.value)); }
  friend StrictFloat cosh(StrictFloat x) { return StrictFloat(std::cosh(x.value)); }
  friend StrictFloat tanh(StrictFloat x) { return StrictFloat(std::tanh(x.value)); }
  friend StrictFloat pow(StrictFloat x, StrictFloat p) { return StrictFloat(std::pow(x.value, p.value)); }
  friend StrictFloat sin(StrictFloat x) { return StrictFloat(std::sin(x.value)); }
  friend StrictFloat cos(StrictFloat x) { return StrictFloat(std::cos(x.value)); }
  friend StrictFloat abs(StrictFloat x) { return StrictFloat(std::abs(x.value)); }

 private:
  /// Through memory: no wider register can carry the result on.
  static float rounded(float x) {
    volatile float stored = x;
    return stored;
  }
};

}  // namespace odemark
