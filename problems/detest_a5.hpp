// A logarithmic spiral, followed over the turn where its slope is about to become infinite.
#pragma once
#include <algorithm>
#include <string>

#include "problems/elliptic.hpp"
#include "problems/family.hpp"

namespace odemark {

/// In the polar coordinates t = r sin(phi), y = r cos(phi) the equation is dr/dphi = r. The slope becomes
/// infinite at phi = 3 pi/4, where t is y0 exp(3 pi/4)/sqrt(2): beyond there is no solution.
template <class Real = double>
struct DetestA5 {
  static constexpr std::string_view id = "detest_a5";
  static constexpr std::string_view title = "Spiral (DETEST A5)";
  static constexpr std::string_view equations = "y' = (y - t)/(y + t)";
  static constexpr std::string_view source =
      "A5 of DETEST, T. E. Hull et al., SIAM J. Numer. Anal. 9 (1972) 603-637, doi:10.1137/0709052";
  static constexpr std::size_t size = 1;
  static constexpr std::array<Component, size> components{{{"y", ""}}};

  Real y0 = 4, t_end = 20;

  static constexpr auto parameters() {
    using P = Parameter<DetestA5, Real>;
    return std::array{P{"y0", "", "initial value", &DetestA5::y0, positive},
                      P{"t_end", "", "end of the interval", &DetestA5::t_end, positive}};
  }
  static constexpr std::array presets{
      Preset{"detest_a5", "", "as published"},
      Preset{"detest_a5_near_end", "t_end=29.75",
             "close to the vertical tangent at t = 29.8: steps have to shrink"}};

  std::string validate() const {
    return t_end < Real(149) / 20 * y0 ? ""
                                       : "beyond t = 7.46 y0 the slope is infinite: keep t_end below 7.45 y0";
  }
  std::array<double, size> scale() const { return {double(y0)}; }
  /// Shrinks with the distance to the vertical tangent.
  double suggested_dt() const {
    return std::min(0.015625 * double(y0), 0.0625 * (7.46 * double(y0) - double(t_end)));
  }

  template <class T>
  void initial(T* y) const {
    y[0] = T(y0);
  }
  template <class T>
  void rhs(const T& t, const T* y, T* dydt) const {
    dydt[0] = (y[0] - t) / (y[0] + t);
  }
  template <class T, class J>
  void jacobian(const T& t, const T* y, J&& j) const {
    const T sum = y[0] + t;
    j(0, 0) = 2 * t / (sum * sum);
  }
  /// The exact flow of any start above 0: t = y0 exp(phi) sin(phi) by Newton steps inside a bracket.
  template <class T>
  void exact(const T& t, const T* start, T* y) const {
    using std::abs, std::cos, std::exp, std::sin;
    T low = -elliptic::pi<T>() / 4, high = 3 * elliptic::pi<T>() / 4, phi = t / (start[0] + t);
    for (int i = 0; i < 500; ++i) {
      const T r = start[0] * exp(phi), miss = r * sin(phi) - t;
      (miss < 0 ? low : high) = phi;
      T next = phi - miss / (r * (sin(phi) + cos(phi)));
      if (!(low <= next && next <= high)) next = (low + high) / 2;
      const T step = abs(next - phi);
      phi = next;
      if (step <= std::numeric_limits<T>::epsilon()) break;
    }
    y[0] = start[0] * exp(phi) * cos(phi);
  }
};

}  // namespace odemark
