// A nerve that fires: slow recovery between sudden jumps, two time scales without being very stiff.
#pragma once
#include <algorithm>

#include "problems/family.hpp"

namespace odemark {

/// State (v, w): membrane potential and recovery.
template <class Real = double>
struct FitzhughNagumo {
  static constexpr std::string_view id = "fitzhugh_nagumo";
  static constexpr std::string_view title = "FitzHugh-Nagumo nerve";
  static constexpr std::string_view equations = "v' = v - v^3/3 - w + I;  w' = eps (v + a - b w)";
  static constexpr std::string_view source =
      "R. FitzHugh, Biophys. J. 1 (1961) 445-466, doi:10.1016/S0006-3495(61)86902-6";
  static constexpr std::size_t size = 2;
  static constexpr std::array<Component, size> components{{{"v", ""}, {"w", ""}}};

  Real a = Real(7) / 10, b = Real(4) / 5, eps = Real(2) / 25, I = Real(1) / 2, v0 = -1, w0 = 1, t_end = 100;

  static constexpr auto parameters() {
    using P = Parameter<FitzhughNagumo, Real>;
    return std::array{P{"a", "", "offset of the recovery", &FitzhughNagumo::a},
                      P{"b", "", "damping of the recovery", &FitzhughNagumo::b},
                      P{"eps", "", "rate of the recovery", &FitzhughNagumo::eps, positive},
                      P{"I", "", "current put in", &FitzhughNagumo::I},
                      P{"v0", "", "initial v", &FitzhughNagumo::v0},
                      P{"w0", "", "initial w", &FitzhughNagumo::w0},
                      P{"t_end", "", "end of the interval", &FitzhughNagumo::t_end, positive}};
  }
  static constexpr std::array presets{
      Preset{"fitzhugh_nagumo", "a=0.7,b=0.8,eps=0.08", "fires again and again"},
      Preset{"fitzhugh_nagumo_at_rest", "a=0.7,b=0.8,eps=0.08,I=0,v0=1,w0=0,t_end=50",
             "one pulse, then rest"},
      Preset{"fitzhugh_nagumo_slow", "a=0.75,b=0.75,eps=0.00048828125,t_end=2000",
             "recovery two thousand times slower than the jump: stiff"}};

  std::array<double, size> scale() const { return {2, 1.5}; }
  double suggested_dt() const { return 0.03125 / std::max(1.0, double(eps)); }

  template <class T>
  void initial(T* y) const {
    y[0] = T(v0), y[1] = T(w0);
  }
  template <class T>
  void rhs(const T&, const T* y, T* dydt) const {
    dydt[0] = y[0] * (1 - y[0] * y[0] / 3) - y[1] + T(I);
    dydt[1] = T(eps) * (y[0] + T(a) - T(b) * y[1]);
  }
  template <class T, class J>
  void jacobian(const T&, const T* y, J&& j) const {
    j(0, 0) = 1 - y[0] * y[0], j(0, 1) = T(-1);
    j(1, 0) = T(eps), j(1, 1) = -(T(eps) * T(b));
  }
};

}  // namespace odemark
