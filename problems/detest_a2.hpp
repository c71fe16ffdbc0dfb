// Decay by the cube: a smooth scalar whose solution falls like 1/sqrt(t), never like an exponential.
#pragma once
#include "problems/family.hpp"

namespace odemark {

template <class Real = double>
struct DetestA2 {
  static constexpr std::string_view id = "detest_a2";
  static constexpr std::string_view title = "Cubic decay (DETEST A2)";
  static constexpr std::string_view equations = "y' = -k y^3/2";
  static constexpr std::string_view source =
      "A2 of DETEST, T. E. Hull et al., SIAM J. Numer. Anal. 9 (1972) 603-637, doi:10.1137/0709052";
  static constexpr std::size_t size = 1;
  static constexpr std::array<Component, size> components{{{"y", ""}}};

  Real k = 1, y0 = 1, t_end = 20;

  static constexpr auto parameters() {
    using P = Parameter<DetestA2, Real>;
    return std::array{P{"k", "", "rate", &DetestA2::k, positive},
                      P{"y0", "", "initial value", &DetestA2::y0, positive},
                      P{"t_end", "", "end of the interval", &DetestA2::t_end, positive}};
  }
  static constexpr std::array presets{
      Preset{"detest_a2", "", "as published"},
      Preset{"detest_a2_steep", "y0=32,t_end=1",
             "the rate falls by a thousand: a step that fits the start wastes the rest"}};

  std::array<double, size> scale() const { return {double(y0)}; }
  double suggested_dt() const { return 0.03125 / (double(k) * double(y0) * double(y0)); }

  template <class T>
  void initial(T* y) const {
    y[0] = T(y0);
  }
  template <class T>
  void rhs(const T&, const T* y, T* dydt) const {
    dydt[0] = -(T(k) / 2) * (y[0] * y[0] * y[0]);
  }
  template <class T, class J>
  void jacobian(const T&, const T* y, J&& j) const {
    j(0, 0) = -(T(k) / 2) * (3 * (y[0] * y[0]));
  }
  /// The exact flow: y0 is the state at t = 0.
  template <class T>
  void exact(const T& t, const T* start, T* y) const {
    using std::sqrt;
    y[0] = start[0] / sqrt(1 + T(k) * start[0] * start[0] * t);
  }
};

}  // namespace odemark
