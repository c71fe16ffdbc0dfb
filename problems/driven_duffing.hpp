// Duffing's spring under a periodic force: from a forced oscillation to a strange attractor.
#pragma once
#include <algorithm>

#include "problems/family.hpp"

namespace odemark {

/// State (x, v), per mass.
template <class Real = double>
struct DrivenDuffing {
  static constexpr std::string_view id = "driven_duffing";
  static constexpr std::string_view title = "Duffing's spring, driven";
  static constexpr std::string_view equations =
      "x' = v;  v' = -delta v - alpha x - beta x^3 + gamma sin(omega t)";
  static constexpr std::string_view source =
      "E3 of DETEST, T. E. Hull et al., SIAM J. Numer. Anal. 9 (1972) 603-637, doi:10.1137/0709052; Y. Ueda, "
      "J. "
      "Stat. Phys. 20 (1979) 181-196, doi:10.1007/BF01011512";
  static constexpr std::size_t size = 2;
  static constexpr std::array<Component, size> components{{{"x", ""}, {"v", ""}}};
  static constexpr bool force_depends_on_velocity = true;

  Real delta = Real(1) / 8, alpha = -1, beta = 1, gamma = Real(5) / 16, omega = 1, x0 = 1, v0 = 0, t_end = 20;

  static constexpr auto parameters() {
    using P = Parameter<DrivenDuffing, Real>;
    return std::array{P{"delta", "", "damping", &DrivenDuffing::delta, not_negative},
                      P{"alpha", "", "linear stiffness", &DrivenDuffing::alpha},
                      P{"beta", "", "cubic stiffness", &DrivenDuffing::beta},
                      P{"gamma", "", "amplitude of the force", &DrivenDuffing::gamma},
                      P{"omega", "", "angular frequency of the force", &DrivenDuffing::omega, not_negative},
                      P{"x0", "", "initial displacement", &DrivenDuffing::x0},
                      P{"v0", "", "initial velocity", &DrivenDuffing::v0},
                      P{"t_end", "", "end of the interval", &DrivenDuffing::t_end, positive}};
  }
  static constexpr std::array presets{
      Preset{"driven_duffing", "", "two wells: it hops between them"},
      Preset{"driven_duffing_detest_e3", "delta=0,alpha=1,beta=-1/6,gamma=2,omega=2.78535,x0=0,v0=0",
             "E3 of DETEST: a pendulum to third order, driven, undamped"},
      Preset{"driven_duffing_ueda", "delta=0.0625,alpha=0,beta=1,gamma=7.5,omega=1,x0=3,v0=0,t_end=30",
             "Ueda's strange attractor: chaos in five periods"}};

  std::array<double, size> scale() const { return {2, 4}; }
  double suggested_dt() const { return 0.015625; }

  template <class T>
  void initial(T* y) const {
    y[0] = T(x0), y[1] = T(v0);
  }
  template <class T>
  void acceleration(const T& t, const T* y, T* a) const {
    using std::sin;
    a[0] = T(gamma) * sin(T(omega) * t) - (T(alpha) + T(beta) * (y[0] * y[0])) * y[0] - T(delta) * y[1];
  }
  template <class T>
  void rhs(const T& t, const T* y, T* dydt) const {
    dydt[0] = y[1];
    acceleration(t, y, &dydt[1]);
  }
  template <class T, class J>
  void jacobian(const T&, const T* y, J&& j) const {
    j(0, 0) = T(0), j(0, 1) = T(1);
    j(1, 0) = -(T(alpha) + 3 * T(beta) * (y[0] * y[0])), j(1, 1) = -T(delta);
  }
  template <class T, class L>
  void linear_part(L&& l) const {
    l(0, 0) = T(0), l(0, 1) = T(1);
    l(1, 0) = -T(alpha), l(1, 1) = -T(delta);
  }
};

}  // namespace odemark
