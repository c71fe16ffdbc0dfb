// Growth and decay by turns: an oscillating rate, known exactly.
#pragma once
#include "problems/family.hpp"

namespace odemark {

template <class Real = double>
struct DetestA3 {
  static constexpr std::string_view id = "detest_a3";
  static constexpr std::string_view title = "Oscillating rate (DETEST A3)";
  static constexpr std::string_view equations = "y' = a y cos(omega t)";
  static constexpr std::string_view source =
      "A3 of DETEST, T. E. Hull et al., SIAM J. Numer. Anal. 9 (1972) 603-637, doi:10.1137/0709052";
  static constexpr std::size_t size = 1;
  static constexpr std::array<Component, size> components{{{"y", ""}}};

  Real a = 1, omega = 1, t_end = 20;

  static constexpr auto parameters() {
    using P = Parameter<DetestA3, Real>;
    return std::array{P{"a", "1/s", "largest growth rate", &DetestA3::a, positive},
                      P{"omega", "rad/s", "angular frequency of the rate", &DetestA3::omega, positive},
                      P{"t_end", "s", "end of the interval", &DetestA3::t_end, positive}};
  }
  static constexpr std::array presets{Preset{"detest_a3", "", "as published: three swings between 1/e and e"},
                                      Preset{"detest_a3_strong", "a=16,omega=2,t_end=8",
                                             "swings over seven decades: small errors are blown up"}};

  std::array<double, size> scale() const { return {std::exp(double(a) / double(omega))}; }
  double suggested_dt() const { return 0.0625 / (double(a) + double(omega)); }

  template <class T>
  void initial(T* y) const {
    y[0] = T(1);
  }
  template <class T>
  void rhs(const T& t, const T* y, T* dydt) const {
    using std::cos;
    dydt[0] = T(a) * (y[0] * cos(T(omega) * t));
  }
  template <class T, class J>
  void jacobian(const T& t, const T*, J&& j) const {
    using std::cos;
    j(0, 0) = T(a) * cos(T(omega) * t);
  }
  /// The exact flow: y0 is the state at t = 0.
  template <class T>
  void exact(const T& t, const T* y0, T* y) const {
    using std::exp, std::sin;
    y[0] = y0[0] * exp(T(a) / T(omega) * sin(T(omega) * t));
  }
};

}  // namespace odemark
