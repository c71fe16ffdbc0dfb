// A chemical clock.
#pragma once
#include <algorithm>

#include "problems/family.hpp"

namespace odemark {

template <class Real = double>
struct Brusselator {
  static constexpr std::string_view id = "brusselator";
  static constexpr std::string_view title = "Brusselator";
  static constexpr std::string_view equations = "x' = A + x^2 y - (B + 1) x;  y' = B x - x^2 y";
  static constexpr std::string_view source =
      "I. Prigogine, R. Lefever, J. Chem. Phys. 48 (1968) 1695-1700, doi:10.1063/1.1668896; E. Hairer, S. P. "
      "Norsett, G. Wanner, Solving Ordinary Differential Equations I, 2nd ed. (Springer, 1993), I.16";
  static constexpr std::size_t size = 2;
  static constexpr std::array<Component, size> components{{{"x", ""}, {"y", ""}}};

  Real A = 1, B = 3, x0 = Real(3) / 2, y0 = 3, t_end = 20;

  static constexpr auto parameters() {
    using P = Parameter<Brusselator, Real>;
    return std::array{P{"A", "", "feed of x", &Brusselator::A, positive},
                      P{"B", "", "feed that turns x into y", &Brusselator::B, positive},
                      P{"x0", "", "initial x", &Brusselator::x0}, P{"y0", "", "initial y", &Brusselator::y0},
                      P{"t_end", "", "end of the interval", &Brusselator::t_end, positive}};
  }
  static constexpr std::array presets{Preset{"brusselator", "", "drawn to the limit cycle, period 7.16"},
                                      Preset{"brusselator_damped", "A=1,B=1.75,t_end=30",
                                             "below the bifurcation at B = 2: it spirals to rest"},
                                      Preset{"brusselator_relaxation", "A=1,B=8,x0=1,y0=4,t_end=30",
                                             "spikes between long pauses: stiff by turns"}};

  std::array<double, size> scale() const { return {std::max(2.0, double(B)), std::max(2.0, double(B))}; }
  double suggested_dt() const { return 0.03125 / std::max(4.0, double(B) * double(B)); }

  template <class T>
  void initial(T* y) const {
    y[0] = T(x0), y[1] = T(y0);
  }
  template <class T>
  void rhs(const T&, const T* y, T* dydt) const {
    const T made = y[0] * y[0] * y[1];
    dydt[0] = T(A) + made - (T(B) + 1) * y[0];
    dydt[1] = T(B) * y[0] - made;
  }
  template <class T, class J>
  void jacobian(const T&, const T* y, J&& j) const {
    const T xy = 2 * y[0] * y[1], xx = y[0] * y[0];
    j(0, 0) = xy - (T(B) + 1), j(0, 1) = xx;
    j(1, 0) = T(B) - xy, j(1, 1) = -xx;
  }
};

}  // namespace odemark
