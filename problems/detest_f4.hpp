// F4 of DETEST: two laws, one after the other.
#pragma once
#include <algorithm>

#include "problems/family.hpp"

namespace odemark {

template <class Real = double>
struct DetestF4 {
  static constexpr std::string_view id = "detest_f4";
  static constexpr std::string_view title = "Two laws, one after the other (DETEST F4)";
  static constexpr std::string_view equations =
      "y' = -2/21 - 120 (t - 5)/(1 + 4 (t - 5)^2)^16 for t < 10, -2 y after";
  static constexpr std::string_view source =
      "F4 of DETEST, W. H. Enright, J. D. Pryce, ACM Trans. Math. Softw. 13 (1987) 1-27, "
      "doi:10.1145/23002.27645";
  static constexpr std::size_t size = 1;
  static constexpr std::array<Component, size> components{{{"y", ""}}};

  Real t_switch = 10, t_end = 20;

  static constexpr auto parameters() {
    using P = Parameter<DetestF4, Real>;
    return std::array{P{"t_switch", "s", "the second law begins", &DetestF4::t_switch, not_negative},
                      P{"t_end", "s", "end of the interval", &DetestF4::t_end, positive}};
  }
  static constexpr std::array presets{
      Preset{"detest_f4", "", "as published: a needle at 5 s, a jump at 10 s, and then decay"},
      Preset{"detest_f4_early", "t_switch=4.6875,t_end=8", "the jump on the flank of the needle"}};

  std::array<double, size> scale() const { return {1}; }
  double suggested_dt() const { return 1.0 / 64; }
  std::array<double, 1> switch_times() const { return {double(t_switch)}; }
  DetestF4 during(std::size_t phase) const {
    DetestF4 held = *this;
    held.t_switch =
        phase == 0 ? std::numeric_limits<Real>::infinity() : Real(-std::numeric_limits<Real>::infinity());
    return held;
  }

  template <class T>
  void initial(T* y) const {
    y[0] = T(1);
  }
  template <class T>
  void rhs(const T& t, const T* y, T* dydt) const {
    const T first = step_at(t, t_switch, Real(1), Real(0)), u = t - 5, q = 1 + 4 * u * u;
    const T q2 = q * q, q4 = q2 * q2, q8 = q4 * q4;
    dydt[0] = first * (-T(Real(2) / 21) - 120 * u / (q8 * q8)) - (1 - first) * 2 * y[0];
  }
  template <class T, class J>
  void jacobian(const T& t, const T*, J&& j) const {
    j(0, 0) = -2 * (1 - step_at(t, t_switch, Real(1), Real(0)));
  }
  /// The exact flow: y0 is the state at t = 0.
  template <class T>
  void exact(const T& t, const T* y0, T* y) const {
    using std::exp;
    const T until = std::clamp(T(t_switch), T(0), t);
    y[0] = y0[0] - T(Real(2) / 21) * until + needle(T(until - 5)) - needle(T(-5));
    y[0] *= exp(-2 * (t - until));
  }

 private:
  template <class T>
  static T needle(const T& u) {
    const T q = 1 + 4 * u * u, q2 = q * q, q4 = q2 * q2, q8 = q4 * q4;
    return 1 / (q8 * q4 * q2 * q);
  }
};

}  // namespace odemark
