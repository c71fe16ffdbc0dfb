// The Belousov-Zhabotinsky reaction: bursts between long pauses, over six decades of concentration.
#pragma once
#include "problems/family.hpp"

namespace odemark {

/// State: HBrO2, Br-, Ce(IV), in their own units.
template <class Real = double>
struct Orego {
  static constexpr std::string_view id = "orego";
  static constexpr std::string_view title = "Oregonator";
  static constexpr std::string_view equations =
      "y1' = s (y2 + y1 (1 - q y1 - y2));  y2' = (y3 - (1 + y1) y2)/s;  y3' = w (y1 - y3);  y(0) = (1, 2, 3)";
  static constexpr std::string_view source =
      "R. J. Field, R. M. Noyes, J. Chem. Phys. 60 (1974) 1877-1884, doi:10.1063/1.1681288; F. Mazzia, C. "
      "Magherini, Test Set for Initial Value Problem Solvers, release 2.4 (2008), problem orego";
  static constexpr std::size_t size = 3;
  static constexpr std::array<Component, size> components{{{"y1", ""}, {"y2", ""}, {"y3", ""}}};

  Real s = Real(7727) / 100, q = Real(8375) / 1000000000, w = Real(161) / 1000, t_end = 360;

  static constexpr auto parameters() {
    using P = Parameter<Orego, Real>;
    return std::array{P{"s", "", "ratio of time scales", &Orego::s, positive},
                      P{"q", "", "loss of y1 by itself", &Orego::q, positive},
                      P{"w", "", "rate of y3", &Orego::w, positive},
                      P{"t_end", "", "end of the interval", &Orego::t_end, positive}};
  }
  static constexpr std::array presets{
      Preset{"orego", "s=77.27,q=8.375e-6,w=0.161", "one period and a bit: two bursts"},
      Preset{"orego_t30", "s=77.27,q=8.375e-6,w=0.161,t_end=30", "the first burst and its recovery"}};

  std::array<double, size> scale() const { return {1e5, 2e3, 3e4}; }
  double suggested_dt() const { return 1e-4; }

  template <class T>
  void initial(T* y) const {
    y[0] = T(1), y[1] = T(2), y[2] = T(3);
  }
  template <class T>
  void rhs(const T&, const T* y, T* dydt) const {
    dydt[0] = T(s) * (y[1] + y[0] * (1 - T(q) * y[0] - y[1]));
    dydt[1] = (y[2] - (1 + y[0]) * y[1]) / T(s);
    dydt[2] = T(w) * (y[0] - y[2]);
  }
  template <class T, class J>
  void jacobian(const T&, const T* y, J&& j) const {
    j(0, 0) = T(s) * (1 - 2 * T(q) * y[0] - y[1]), j(0, 1) = T(s) * (1 - y[0]), j(0, 2) = T(0);
    j(1, 0) = -(y[1] / T(s)), j(1, 1) = -((1 + y[0]) / T(s)), j(1, 2) = 1 / T(s);
    j(2, 0) = T(w), j(2, 1) = T(0), j(2, 2) = -T(w);
  }
};

}  // namespace odemark
