// Two stiff components driven at two frequencies: the standard test of methods with more than one step size.
#pragma once
#include <algorithm>

#include "problems/family.hpp"

namespace odemark {

/// With u = y1^2 - 3 - cos(omega t) and v = y2^2 - 2 - cos t the equations are u' = lambda_fast u and
/// v' = lambda_slow v: the diagonal case, whose flow is known.
template <class Real = double>
struct KvaernoProtheroRobinson {
  static constexpr std::string_view id = "kvaerno_prothero_robinson";
  static constexpr std::string_view title = "Kvaerno-Prothero-Robinson problem";
  static constexpr std::string_view equations =
      "y1' = (lambda_fast (y1^2 - 3 - cos(omega t)) - omega sin(omega t))/(2 y1);  y2' = (lambda_slow (y2^2 "
      "- "
      "2 - cos t) - sin t)/(2 y2)";
  static constexpr std::string_view source =
      "A. Sandu, SIAM J. Numer. Anal. 57 (2019) 2300-2327, doi:10.1137/18M1205492; here without coupling";
  static constexpr std::size_t size = 2;
  static constexpr std::array<Component, size> components{{{"y1", ""}, {"y2", ""}}};

  Real lambda_fast = -10, lambda_slow = -10, omega = 20, y1 = 2, y2 = Real(7) / 4, t_end = 8;

  static constexpr auto parameters() {
    using P = Parameter<KvaernoProtheroRobinson, Real>;
    const Range decaying{.highest = 0};
    return std::array{
        P{"lambda_fast", "1/s", "rate of the fast component", &KvaernoProtheroRobinson::lambda_fast,
          decaying},
        P{"lambda_slow", "1/s", "rate of the slow component", &KvaernoProtheroRobinson::lambda_slow,
          decaying},
        P{"omega", "rad/s", "angular frequency of the fast drive", &KvaernoProtheroRobinson::omega, positive},
        P{"y1", "", "initial fast component; 2 is on the smooth solution", &KvaernoProtheroRobinson::y1,
          Range{.lowest = 2}},
        P{"y2", "", "initial slow component; sqrt(3) is on the smooth solution", &KvaernoProtheroRobinson::y2,
          Range{.lowest = 1.75}},
        P{"t_end", "s", "end of the interval", &KvaernoProtheroRobinson::t_end, positive}};
  }
  static constexpr std::array presets{
      Preset{"kvaerno_prothero_robinson", "",
             "25 fast periods to 1.3 slow ones; starts beside the smooth solution"},
      Preset{"kvaerno_prothero_robinson_stiff", "lambda_fast=-1024,lambda_slow=-64,omega=8,t_end=2",
             "stiff, the slow component too"}};

  std::array<double, size> scale() const { return {std::max(2.0, double(y1)), std::max(1.75, double(y2))}; }
  double suggested_dt() const {
    return 0.03125 / std::max({double(omega), -double(lambda_fast), -double(lambda_slow), 1.0});
  }

  template <class T>
  void initial(T* y) const {
    y[0] = T(y1), y[1] = T(y2);
  }
  template <class T>
  void rhs(const T& t, const T* y, T* dydt) const {
    using std::cos, std::sin;
    const T fast = T(omega) * t;
    dydt[0] = (T(lambda_fast) * (y[0] * y[0] - 3 - cos(fast)) - T(omega) * sin(fast)) / (2 * y[0]);
    dydt[1] = (T(lambda_slow) * (y[1] * y[1] - 2 - cos(t)) - sin(t)) / (2 * y[1]);
  }
  template <class T, class J>
  void jacobian(const T& t, const T* y, J&& j) const {
    using std::cos, std::sin;
    const T fast = T(omega) * t;
    j(0, 0) = T(lambda_fast) -
              (T(lambda_fast) * (y[0] * y[0] - 3 - cos(fast)) - T(omega) * sin(fast)) / (2 * y[0] * y[0]);
    j(1, 1) = T(lambda_slow) - (T(lambda_slow) * (y[1] * y[1] - 2 - cos(t)) - sin(t)) / (2 * y[1] * y[1]);
    j(0, 1) = T(0), j(1, 0) = T(0);
  }
  /// The exact flow: y0 is the state at t = 0, both components above 0.
  template <class T>
  void exact(const T& t, const T* y0, T* y) const {
    using std::cos, std::exp, std::sqrt;
    const T u = (y0[0] - 2) * (y0[0] + 2), v = y0[1] * y0[1] - 3;
    y[0] = sqrt(3 + cos(T(omega) * t) + u * exp(T(lambda_fast) * t));
    y[1] = sqrt(2 + cos(t) + v * exp(T(lambda_slow) * t));
  }
};

}  // namespace odemark
