// Kaps' problem: a nonlinear pair with a parabola as slow manifold, where order reduction shows.
#pragma once
#include "problems/family.hpp"

namespace odemark {

/// From (1, 1) the solution is (exp(-2t), exp(-t)) for every eps. It starts on the slow manifold y1 = y2^2
/// up to eps and never leaves it.
template <class Real = double>
struct Kaps {
  static constexpr std::string_view id = "kaps";
  static constexpr std::string_view title = "Kaps' problem";
  static constexpr std::string_view equations = "y1' = -(2 + 1/eps) y1 + y2^2/eps;  y2' = y1 - y2 - y2^2";
  static constexpr std::string_view source =
      "P. Kaps, in: The Teubner Seminar on Numerical Treatment of Differential Equations, Martin Luther "
      "University Halle (1981); K. Dekker, J. G. Verwer, Stability of Runge-Kutta Methods for Stiff "
      "Nonlinear "
      "Differential Equations (North-Holland, 1984), 5.6";
  static constexpr std::size_t size = 2;
  static constexpr std::array<Component, size> components{{{"y1", ""}, {"y2", ""}}};

  Real eps = Real(1) / 1024, y1 = 1, y2 = 1, t_end = 1;

  static constexpr auto parameters() {
    using P = Parameter<Kaps, Real>;
    return std::array{P{"eps", "s", "time in which y1 comes to the slow manifold", &Kaps::eps, positive},
                      P{"y1", "", "initial y1", &Kaps::y1}, P{"y2", "", "initial y2", &Kaps::y2},
                      P{"t_end", "s", "end of the interval", &Kaps::t_end, positive}};
  }
  static constexpr std::array presets{
      Preset{"kaps", "", "eps = 2^-10: moderately stiff"},
      Preset{"kaps_smooth", "eps=1", "not stiff: the same solution at classical order"},
      Preset{"kaps_stiff", "eps=1.52587890625e-05", "eps = 2^-16: stage order alone counts"}};

  std::array<double, size> scale() const { return {1, 1}; }
  double suggested_dt() const { return 0.03125 / (3 + 1 / double(eps)); }

  template <class T>
  void initial(T* y) const {
    y[0] = T(y1), y[1] = T(y2);
  }
  template <class T>
  void rhs(const T&, const T* y, T* dydt) const {
    dydt[0] = (y[1] * y[1] - y[0]) / T(eps) - 2 * y[0];
    dydt[1] = y[0] - y[1] * (1 + y[1]);
  }
  template <class T, class J>
  void jacobian(const T&, const T* y, J&& j) const {
    j(0, 0) = -1 / T(eps) - 2, j(0, 1) = 2 * y[1] / T(eps);
    j(1, 0) = T(1), j(1, 1) = -1 - 2 * y[1];
  }
};

}  // namespace odemark
