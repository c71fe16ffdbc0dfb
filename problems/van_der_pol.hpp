// Van der Pol's oscillator: from nearly harmonic to stiff by one parameter.
#pragma once
#include <algorithm>

#include "problems/family.hpp"

namespace odemark {

/// State (x, v), in the time in which the linear oscillator has the angular frequency 1.
template <class Real = double>
struct VanDerPol {
  static constexpr std::string_view id = "van_der_pol";
  static constexpr std::string_view title = "Van der Pol oscillator";
  static constexpr std::string_view equations = "x' = v;  v' = mu (1 - x^2) v - x";
  static constexpr std::string_view source =
      "B. van der Pol, Phil. Mag. 2 (1926) 978-992, doi:10.1080/14786442608564127; mu = 1000 on [0, 2000]: "
      "F. Mazzia, C. Magherini, Test Set for Initial Value Problem Solvers, release 2.4 (2008), problem "
      "vdpolm";
  static constexpr std::size_t size = 2;
  static constexpr std::array<Component, size> components{{{"x", ""}, {"v", ""}}};
  static constexpr bool force_depends_on_velocity = true;

  Real mu = 1, x0 = 2, v0 = 0, t_end = 11;

  static constexpr auto parameters() {
    using P = Parameter<VanDerPol, Real>;
    return std::array{P{"mu", "", "strength of the nonlinear damping", &VanDerPol::mu, not_negative},
                      P{"x0", "", "initial displacement", &VanDerPol::x0},
                      P{"v0", "", "initial velocity", &VanDerPol::v0},
                      P{"t_end", "", "end of the interval", &VanDerPol::t_end, positive}};
  }
  static constexpr std::array presets{
      Preset{"van_der_pol_mu1", "mu=1,t_end=11", "not stiff; period 6.66"},
      Preset{"van_der_pol_mu5", "mu=5,t_end=20", "relaxation begins; period 11.6"},
      Preset{"van_der_pol_mu10", "mu=10,t_end=25", "mildly stiff; period 19.1"},
      Preset{"van_der_pol_mu100", "mu=100,t_end=200", "stiff; period 163"},
      Preset{"van_der_pol_mu1000", "mu=1000,t_end=2000", "the stiff test of the literature; period 1614"},
      Preset{"van_der_pol_mu1e6", "mu=1e6,t_end=2e6",
             "past the first jump, which takes a millionth of the way"},
      Preset{"van_der_pol_detest_e2", "mu=1,t_end=20", "DETEST E2: three periods"}};

  std::array<double, size> scale() const { return {2, std::max(2.0, 1.5 * double(mu))}; }
  double suggested_dt() const { return 0.05 / std::max(1.0, 3 * double(mu)); }

  template <class T>
  void initial(T* y) const {
    y[0] = T(x0), y[1] = T(v0);
  }
  template <class T>
  void acceleration(const T&, const T* y, T* a) const {
    a[0] = T(mu) * ((1 - y[0] * y[0]) * y[1]) - y[0];
  }
  template <class T>
  void rhs(const T& t, const T* y, T* dydt) const {
    dydt[0] = y[1];
    acceleration(t, y, &dydt[1]);
  }
  template <class T, class J>
  void jacobian(const T&, const T* y, J&& j) const {
    j(0, 0) = T(0), j(0, 1) = T(1);
    j(1, 0) = -2 * T(mu) * y[0] * y[1] - 1, j(1, 1) = T(mu) * (1 - y[0] * y[0]);
  }
};

}  // namespace odemark
