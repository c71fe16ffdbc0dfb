// Stiff linear springs alternate with soft quartic ones: fast oscillations that exchange energy slowly.
#pragma once
#include <algorithm>

#include "problems/numbered.hpp"

namespace odemark {

/// State: x1..x3 displacements of the three stiff springs' centres, x4..x6 their stretches (both times sqrt
/// 2), then the velocities. The sum of the energies of the stiff springs is nearly constant for very long.
template <class Real = double>
struct StiffFput {
  static constexpr std::string_view id = "stiff_fput";
  static constexpr std::string_view title = "Chain of stiff and soft springs";
  static constexpr std::string_view equations =
      "H = sum yi^2/2 + omega^2/2 (x4^2 + x5^2 + x6^2) + ((x1 - x4)^4 + (x2 - x5 - x1 - x4)^4 + (x3 - x6 - "
      "x2 - "
      "x5)^4 + (x3 + x6)^4)/4;  x1 = y1 = y4 = 1, x4 = 1/omega, the others 0";
  static constexpr std::string_view source =
      "E. Hairer, C. Lubich, G. Wanner, Geometric Numerical Integration, 2nd ed. (Springer, 2006), I.5.1";
  static constexpr std::size_t pairs = 3, half = 2 * pairs, size = 2 * half;
  static constexpr std::array<Component, size> components =
      joined(numbered<"x", half>(""), numbered<"y", half>(""));
  static constexpr std::array<std::string_view, 1> invariant_names{"energy"};
  static constexpr bool force_depends_on_velocity = false;

  Real omega = 50, t_end = 10;

  static constexpr auto parameters() {
    using P = Parameter<StiffFput, Real>;
    return std::array{P{"omega", "", "angular frequency of the stiff springs", &StiffFput::omega, positive},
                      P{"t_end", "", "end of the interval", &StiffFput::t_end, positive}};
  }
  static constexpr std::array presets{
      Preset{"stiff_fput", "", "omega = 50: eighty fast periods to a few slow ones"},
      Preset{"stiff_fput_exchange", "t_end=60", "long enough for energy to go from spring to spring"},
      Preset{"stiff_fput_soft", "omega=4", "frequencies hardly apart"}};

  std::array<double, size> scale() const {
    std::array<double, size> out{};
    for (std::size_t i = 0; i < half; ++i)
      out[i] = i < pairs ? 1 : 1 / std::max(1.0, double(omega)), out[i + half] = 1;
    return out;
  }
  double suggested_dt() const { return 0.0625 / std::max(4.0, double(omega)); }

  template <class T>
  void initial(T* y) const {
    for (std::size_t i = 0; i < size; ++i) y[i] = T(0);
    y[0] = y[half] = y[half + pairs] = T(1);
    y[pairs] = 1 / T(omega);
  }
  template <class T>
  void acceleration(const T&, const T* y, T* a) const {
    const T square = T(omega) * T(omega);
    T left = cube(stretch(y, 0));
    for (std::size_t i = 0; i < pairs; ++i) {
      const T right = cube(stretch(y, i + 1));
      a[i] = right - left;
      a[i + pairs] = left + right - square * y[i + pairs];
      left = right;
    }
  }
  template <class T>
  void rhs(const T& t, const T* y, T* dydt) const {
    for (std::size_t i = 0; i < half; ++i) dydt[i] = y[i + half];
    acceleration(t, y, dydt + half);
  }
  /// The stiff springs alone.
  template <class T, class L>
  void linear_part(L&& l) const {
    const T square = T(omega) * T(omega);
    for (std::size_t row = 0; row < size; ++row)
      for (std::size_t column = 0; column < size; ++column)
        l(row, column) = row + half == column                      ? T(1)
                         : column + half == row && column >= pairs ? T(-square)
                                                                   : T(0);
  }
  template <class T>
  void invariants(const T* y, T* out) const {
    out[0] = T(0);
    for (std::size_t i = 0; i < half; ++i) out[0] = out[0] + y[i + half] * y[i + half] / 2;
    for (std::size_t i = pairs; i < half; ++i) {
      const T u = T(omega) * y[i];
      out[0] = out[0] + u * u / 2;
    }
    for (std::size_t i = 0; i <= pairs; ++i) {
      const T r = stretch(y, i);
      out[0] = out[0] + r * r * (r * r) / 4;
    }
  }

 private:
  template <class T>
  static T cube(const T& r) {
    return r * r * r;
  }
  /// Of soft spring i, before pair i.
  template <class T>
  static T stretch(const T* y, std::size_t i) {
    if (i == 0) return y[0] - y[pairs];
    if (i == pairs) return -(y[pairs - 1] + y[half - 1]);
    return y[i] - y[i + pairs] - (y[i - 1] + y[i - 1 + pairs]);
  }
};

}  // namespace odemark
