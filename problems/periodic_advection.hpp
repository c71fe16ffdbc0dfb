// A hump carried round a ring: eigenvalues on, or near, the imaginary axis.
#pragma once
#include "problems/elliptic.hpp"
#include "problems/numbered.hpp"

namespace odemark {

/// State: u at 32 points of a ring. upwinding = 0 takes central differences (nothing is damped), 1 upwind
/// differences (short waves are).
template <class Real = double>
struct PeriodicAdvection {
  static constexpr std::string_view id = "periodic_advection";
  static constexpr std::string_view title = "Advection round a ring, 32 points";
  static constexpr std::string_view equations =
      "ui' = -(c/dx) ((1 + upwinding)/2 (ui - u(i-1)) + (1 - upwinding)/2 (u(i+1) - ui)), dx = length/32, "
      "u32 = u0;  ui(0) = 16 s^2 (1 - s)^2, s = i/32";
  static constexpr std::string_view source =
      "W. Hundsdorfer, J. G. Verwer, Numerical Solution of Time-Dependent Advection-Diffusion-Reaction "
      "Equations (Springer, 2003), I.3, doi:10.1007/978-3-662-09017-6";
  static constexpr std::size_t size = 32;
  static constexpr std::array<Component, size> components = numbered<"u", size>("");
  static constexpr std::array<std::string_view, 1> invariant_names{"total"};

  Real c = 1, upwinding = 0, length = 1, t_end = 2;

  static constexpr auto parameters() {
    using P = Parameter<PeriodicAdvection, Real>;
    return std::array{P{"c", "m/s", "speed", &PeriodicAdvection::c, positive},
                      P{"upwinding", "", "0: central differences, 1: upwind", &PeriodicAdvection::upwinding,
                        Range{.lowest = 0, .highest = 1}},
                      P{"length", "m", "circumference", &PeriodicAdvection::length, positive},
                      P{"t_end", "s", "end of the interval", &PeriodicAdvection::t_end, positive}};
  }
  static constexpr std::array presets{
      Preset{"periodic_advection", "", "central differences over two transits: purely imaginary eigenvalues"},
      Preset{"periodic_advection_upwind", "upwinding=1", "upwind: eigenvalues on a circle beside the axis"},
      Preset{"periodic_advection_biased", "upwinding=0.25", "an ellipse close to the axis"}};

  std::array<double, size> scale() const {
    std::array<double, size> one;
    one.fill(1);
    return one;
  }
  double suggested_dt() const { return 0.125 / double(rate<Real>()); }

  template <class T>
  void initial(T* y) const {
    for (std::size_t i = 0; i < size; ++i) {
      const T s = T(int(i)) / int(size), hump = 4 * s * (1 - s);
      y[i] = hump * hump;
    }
  }
  template <class T>
  void rhs(const T&, const T* y, T* dydt) const {
    const T behind = rate<T>() * (1 + T(upwinding)) / 2, ahead = rate<T>() * (1 - T(upwinding)) / 2;
    for (std::size_t i = 0; i < size; ++i) {
      const T &left = y[(i + size - 1) % size], &right = y[(i + 1) % size];
      dydt[i] = behind * (left - y[i]) + ahead * (y[i] - right);
    }
  }
  template <class T, class J>
  void jacobian(const T&, const T*, J&& j) const {
    linear_part<T>(j);
  }
  template <class T, class L>
  void linear_part(L&& l) const {
    const T behind = rate<T>() * (1 + T(upwinding)) / 2, ahead = rate<T>() * (1 - T(upwinding)) / 2;
    for (std::size_t row = 0; row < size; ++row)
      for (std::size_t column = 0; column < size; ++column)
        l(row, column) = row == column                ? ahead - behind
                         : (column + 1) % size == row ? behind
                         : (row + 1) % size == column ? T(-ahead)
                                                      : T(0);
  }
  /// The same system with every drive removed: 0 is its fixed point.
  PeriodicAdvection homogeneous() const { return *this; }

  /// The exact flow: wave m, exp(2 pi i m x/length), is multiplied by exp(lambda t) with lambda =
  /// -(c/dx) (upwinding (1 - cos) + i sin) of the angle 2 pi m/32.
  template <class T>
  void exact(const T& t, const T* y0, T* y) const {
    using std::cos, std::exp, std::sin;
    std::array<T, size> response, sum;  // of a point i cells down the stream to a unit at 0
    const T angle = 2 * elliptic::pi<T>() / int(size), turned = rate<T>() * t;
    for (std::size_t i = 0; i < size; ++i) response[i] = sum[i] = T(0);
    for (std::size_t m = 0; m < size; ++m) {
      const T half = sin(T(int(m)) * angle / 2);
      const T left = exp(-(2 * turned * T(upwinding) * half * half)) / int(size);
      const T phase = turned * sin(T(int(m)) * angle);
      for (std::size_t i = 0; i < size; ++i)
        response[i] = response[i] + left * cos(T(int(m * i % size)) * angle - phase);
    }
    for (std::size_t i = 0; i < size; ++i)
      for (std::size_t j = 0; j < size; ++j) sum[i] = sum[i] + response[(i + size - j) % size] * y0[j];
    for (std::size_t i = 0; i < size; ++i) y[i] = sum[i];
  }
  template <class T>
  void invariants(const T* y, T* out) const {
    out[0] = T(0);
    for (std::size_t i = 0; i < size; ++i) out[0] = out[0] + y[i];
  }

 private:
  /// c/dx
  template <class T>
  T rate() const {
    return T(c) * int(size) / T(length);
  }
};

}  // namespace odemark
