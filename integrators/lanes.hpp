// Ensembles: a number that is several numbers, one per copy of the system. A right-hand side runs on it
// unchanged.
#pragma once

#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>

#include "integrators/state.hpp"

namespace odemark {

/// `Width` independent copies side by side; every operation is a loop over them that compilers turn into
/// vector instructions. Lane i gets the bits that a run of its own would get.
template <class T, std::size_t Width>
struct alignas(sizeof(T) * Width) Lanes {
  std::array<T, Width> lane{};

  Lanes() = default;
  Lanes(T same) { lane.fill(same); }
  explicit Lanes(int same) : Lanes(static_cast<T>(same)) {}

  template <class F>
  [[gnu::always_inline]] static Lanes each(F&& f) {
    Lanes out;
    for (std::size_t i = 0; i < Width; ++i) out.lane[i] = f(i);
    return out;
  }
  Lanes operator-() const {
    return each([&](std::size_t i) { return -lane[i]; });
  }
  friend Lanes operator+(const Lanes& a, const Lanes& b) {
    return each([&](std::size_t i) { return a.lane[i] + b.lane[i]; });
  }
  friend Lanes operator-(const Lanes& a, const Lanes& b) {
    return each([&](std::size_t i) { return a.lane[i] - b.lane[i]; });
  }
  friend Lanes operator*(const Lanes& a, const Lanes& b) {
    return each([&](std::size_t i) { return a.lane[i] * b.lane[i]; });
  }
  friend Lanes operator/(const Lanes& a, const Lanes& b) {
    return each([&](std::size_t i) { return a.lane[i] / b.lane[i]; });
  }
  Lanes& operator+=(const Lanes& o) { return *this = *this + o; }
  Lanes& operator-=(const Lanes& o) { return *this = *this - o; }
  Lanes& operator*=(const Lanes& o) { return *this = *this * o; }
  template <std::same_as<int> I>
  friend Lanes operator*(I a, const Lanes& b) {
    return Lanes(a) * b;
  }
  template <std::same_as<int> I>
  friend Lanes operator-(I a, const Lanes& b) {
    return Lanes(a) - b;
  }
  template <std::same_as<int> I>
  friend Lanes operator+(I a, const Lanes& b) {
    return Lanes(a) + b;
  }
  template <std::same_as<int> I>
  friend Lanes operator/(const Lanes& a, I b) {
    return a / Lanes(b);
  }

  friend Lanes sqrt(const Lanes& x) {
    return each([&](std::size_t i) { return std::sqrt(x.lane[i]); });
  }
  friend Lanes sin(const Lanes& x) {
    return each([&](std::size_t i) { return std::sin(x.lane[i]); });
  }
  friend Lanes cos(const Lanes& x) {
    return each([&](std::size_t i) { return std::cos(x.lane[i]); });
  }
  friend Lanes exp(const Lanes& x) {
    return each([&](std::size_t i) { return std::exp(x.lane[i]); });
  }
  friend Lanes log(const Lanes& x) {
    return each([&](std::size_t i) { return std::log(x.lane[i]); });
  }
  friend Lanes sinh(const Lanes& x) {
    return each([&](std::size_t i) { return std::sinh(x.lane[i]); });
  }
  friend Lanes cosh(const Lanes& x) {
    return each([&](std::size_t i) { return std::cosh(x.lane[i]); });
  }
  friend Lanes tanh(const Lanes& x) {
    return each([&](std::size_t i) { return std::tanh(x.lane[i]); });
  }
  friend Lanes atan(const Lanes& x) {
    return each([&](std::size_t i) { return std::atan(x.lane[i]); });
  }
  friend Lanes pow(const Lanes& x, const Lanes& p) {
    return each([&](std::size_t i) { return std::pow(x.lane[i], p.lane[i]); });
  }
  friend Lanes abs(const Lanes& x) {
    return each([&](std::size_t i) { return std::abs(x.lane[i]); });
  }
  friend bool isfinite(const Lanes& x) {
    bool all = true;
    for (const T v : x.lane) all = all && std::isfinite(v);
    return all;
  }
};

/// Time and step are common to all lanes.
template <class T, std::size_t Width>
struct TimeOf<Lanes<T, Width>> {
  using type = T;
};

}  // namespace odemark
