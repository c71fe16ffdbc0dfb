// Predators and prey: a closed orbit that explicit Euler leaves outwards and implicit Euler inwards.
#pragma once
#include <algorithm>

#include "problems/family.hpp"

namespace odemark {

/// State: prey, predators; both stay above 0.
template <class Real = double>
struct LotkaVolterra {
  static constexpr std::string_view id = "lotka_volterra";
  static constexpr std::string_view title = "Lotka-Volterra equations";
  static constexpr std::string_view equations =
      "prey' = prey (a - b predators);  predators' = predators (c prey - d)";
  static constexpr std::string_view source =
      "V. Volterra, Nature 118 (1926) 558-560, doi:10.1038/118558a0; B1 of DETEST, T. E. Hull et al., SIAM "
      "J. "
      "Numer. Anal. 9 (1972) 603-637, doi:10.1137/0709052";
  static constexpr std::size_t size = 2;
  static constexpr std::array<Component, size> components{{{"prey", ""}, {"predators", ""}}};
  static constexpr std::array<std::string_view, 1> invariant_names{"first_integral"};

  Real a = Real(3) / 2, b = 1, c = 1, d = 3, prey0 = 1, predators0 = 1, t_end = 10;

  static constexpr auto parameters() {
    using P = Parameter<LotkaVolterra, Real>;
    return std::array{P{"a", "1/s", "growth rate of prey left alone", &LotkaVolterra::a, positive},
                      P{"b", "1/s", "rate at which a predator kills", &LotkaVolterra::b, positive},
                      P{"c", "1/s", "growth rate of predators per prey", &LotkaVolterra::c, positive},
                      P{"d", "1/s", "death rate of predators", &LotkaVolterra::d, positive},
                      P{"prey0", "", "initial prey", &LotkaVolterra::prey0, positive},
                      P{"predators0", "", "initial predators", &LotkaVolterra::predators0, positive},
                      P{"t_end", "s", "end of the interval", &LotkaVolterra::t_end, positive}};
  }
  static constexpr std::array presets{
      Preset{"lotka_volterra", "", "three rounds, prey between 1 and 7"},
      Preset{"lotka_volterra_detest_b1", "a=2,b=2,c=1,d=1,prey0=1,predators0=3,t_end=20", "DETEST B1"},
      Preset{"lotka_volterra_extreme", "a=1,b=1,c=1,d=1,prey0=8,predators0=1,t_end=20",
             "predators almost die out: populations over four decades"}};

  std::array<double, size> scale() const {
    return {std::max(2 * double(d) / double(c), double(prey0)),
            std::max(2 * double(a) / double(b), double(predators0))};
  }
  double suggested_dt() const {
    return 0.03125 / (double(a) + double(b) * double(predators0) + double(c) * double(prey0) + double(d));
  }

  template <class T>
  void initial(T* y) const {
    y[0] = T(prey0), y[1] = T(predators0);
  }
  template <class T>
  void rhs(const T&, const T* y, T* dydt) const {
    dydt[0] = y[0] * (T(a) - T(b) * y[1]);
    dydt[1] = y[1] * (T(c) * y[0] - T(d));
  }
  template <class T, class J>
  void jacobian(const T&, const T* y, J&& j) const {
    j(0, 0) = T(a) - T(b) * y[1], j(0, 1) = -(T(b) * y[0]);
    j(1, 0) = T(c) * y[1], j(1, 1) = T(c) * y[0] - T(d);
  }
  template <class T>
  void invariants(const T* y, T* out) const {
    using std::log;
    out[0] = T(c) * y[0] - T(d) * log(y[0]) + T(b) * y[1] - T(a) * log(y[1]);
  }
};

}  // namespace odemark
