// A pulse of heat that spreads along ten cells: a symmetric linear system.
#pragma once
#include "problems/numbered.hpp"
#include "problems/sine_modes.hpp"

namespace odemark {

/// State: what is in each cell; whatever leaves an end is lost.
template <class Real = double>
struct DetestC3 {
  static constexpr std::string_view id = "detest_c3";
  static constexpr std::string_view title = "Diffusion along ten cells (DETEST C3)";
  static constexpr std::string_view equations =
      "yi' = k (y(i-1) - 2 yi + y(i+1)), i = 1..10, y0 = y11 = 0;  y1(0) = 1, the others 0";
  static constexpr std::string_view source =
      "C3 of DETEST, T. E. Hull et al., SIAM J. Numer. Anal. 9 (1972) 603-637, doi:10.1137/0709052";
  static constexpr std::size_t size = 10;
  static constexpr std::array<Component, size> components = numbered<"y", size>("");

  Real k = 1, t_end = 20;

  static constexpr auto parameters() {
    using P = Parameter<DetestC3, Real>;
    return std::array{P{"k", "1/s", "exchange with each neighbour", &DetestC3::k, positive},
                      P{"t_end", "s", "end of the interval", &DetestC3::t_end, positive}};
  }
  static constexpr std::array presets{
      Preset{"detest_c3", "", "as published: a drop of heat at one end spreads"},
      Preset{"detest_c3_fast", "k=64,t_end=1",
             "rates up to 250 /s, and over before the end: a little stiff"}};

  std::array<double, size> scale() const {
    std::array<double, size> one;
    one.fill(1);
    return one;
  }
  double suggested_dt() const { return 0.03125 / double(k); }

  template <class T>
  void initial(T* y) const {
    for (std::size_t i = 0; i < size; ++i) y[i] = T(i == 0 ? 1 : 0);
  }
  template <class T>
  void rhs(const T&, const T* y, T* dydt) const {
    diffusion_rhs<size>(T(k), y, dydt);
  }
  template <class T, class J>
  void jacobian(const T&, const T*, J&& j) const {
    linear_part<T>(j);
  }
  template <class T, class L>
  void linear_part(L&& l) const {
    diffusion_matrix<size>(T(k), l);
  }
  /// The same system with every drive removed: 0 is its fixed point.
  DetestC3 homogeneous() const { return *this; }
  /// The exact flow: y0 is the state at t = 0.
  template <class T>
  void exact(const T& t, const T* y0, T* y) const {
    diffusion_exact<size>(T(k), t, y0, y);
  }
};

}  // namespace odemark
