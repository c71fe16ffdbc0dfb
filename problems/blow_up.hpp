// A solution that becomes infinite in finite time, followed almost up to there.
#pragma once
#include <string>

#include "problems/family.hpp"

namespace odemark {

template <class Real = double>
struct BlowUp {
  static constexpr std::string_view id = "blow_up";
  static constexpr std::string_view title = "Finite-time blow-up";
  static constexpr std::string_view equations = "y' = y^2";
  static constexpr std::string_view source =
      "E. Hairer, S. P. Norsett, G. Wanner, Solving Ordinary Differential Equations I, 2nd ed. (Springer, "
      "1993), I.7";
  static constexpr std::size_t size = 1;
  static constexpr std::array<Component, size> components{{{"y", ""}}};

  Real y0 = 1, t_end = Real(63) / 64;

  static constexpr auto parameters() {
    using P = Parameter<BlowUp, Real>;
    return std::array{P{"y0", "", "initial value", &BlowUp::y0, positive},
                      P{"t_end", "", "end of the interval; the pole is at 1/y0", &BlowUp::t_end, positive}};
  }
  static constexpr std::array presets{
      Preset{"blow_up", "", "up to 64 times the start: the step has to shrink with the distance to the pole"},
      Preset{"blow_up_half", "t_end=0.5", "a harmless half of the way"}};

  std::string validate() const {
    return t_end * y0 < Real(1) ? "" : "the solution is infinite at t = 1/y0: end before that";
  }
  std::array<double, size> scale() const { return {double(y0) / (1 - double(t_end) * double(y0))}; }
  double suggested_dt() const { return 0.0625 / scale()[0]; }

  template <class T>
  void initial(T* y) const {
    y[0] = T(y0);
  }
  template <class T>
  void rhs(const T&, const T* y, T* dydt) const {
    dydt[0] = y[0] * y[0];
  }
  template <class T, class J>
  void jacobian(const T&, const T* y, J&& j) const {
    j(0, 0) = 2 * y[0];
  }
  /// The exact flow: y0 is the state at t = 0.
  template <class T>
  void exact(const T& t, const T* start, T* y) const {
    y[0] = start[0] / (1 - start[0] * t);
  }
};

}  // namespace odemark
