// A pursuit curve: a slope that grows without bound as the end of the chase comes near.
#pragma once
#include <string>

#include "problems/family.hpp"

namespace odemark {

/// State (y, y') over the distance t gone; the chase ends at t = distance.
template <class Real = double>
struct PursuitE5 {
  static constexpr std::string_view id = "pursuit_e5";
  static constexpr std::string_view title = "Pursuit curve (DETEST E5)";
  static constexpr std::string_view equations = "y'' = sqrt(1 + y'^2)/(distance - t)";
  static constexpr std::string_view source =
      "E5 of DETEST, T. E. Hull et al., SIAM J. Numer. Anal. 9 (1972) 603-637, doi:10.1137/0709052; "
      "H. T. Davis, Introduction to Nonlinear Differential and Integral Equations (Dover, 1962), 5.2";
  static constexpr std::size_t size = 2;
  static constexpr std::array<Component, size> components{{{"y", ""}, {"y'", ""}}};
  static constexpr bool force_depends_on_velocity = true;

  Real distance = 25, y0 = 0, v0 = 0, t_end = 20;

  static constexpr auto parameters() {
    using P = Parameter<PursuitE5, Real>;
    return std::array{P{"distance", "", "where the chase ends", &PursuitE5::distance, positive},
                      P{"y0", "", "initial y", &PursuitE5::y0}, P{"v0", "", "initial slope", &PursuitE5::v0},
                      P{"t_end", "", "end of the interval", &PursuitE5::t_end, positive}};
  }
  static constexpr std::array presets{
      Preset{"pursuit_e5", "", "as published"},
      Preset{"pursuit_e5_close", "t_end=24.75", "a hundredth of the way is left: the slope is 50"}};

  std::string validate() const {
    return t_end < distance ? "" : "the chase ends at t = distance: end before that";
  }
  std::array<double, size> scale() const {
    return {double(distance), double(distance) / (double(distance) - double(t_end))};
  }
  double suggested_dt() const { return 0.03125 * (double(distance) - double(t_end)); }

  template <class T>
  void initial(T* y) const {
    y[0] = T(y0), y[1] = T(v0);
  }
  template <class T>
  void acceleration(const T& t, const T* y, T* a) const {
    using std::sqrt;
    a[0] = sqrt(1 + y[1] * y[1]) / (T(distance) - t);
  }
  template <class T>
  void rhs(const T& t, const T* y, T* dydt) const {
    dydt[0] = y[1];
    acceleration(t, y, &dydt[1]);
  }
  template <class T, class J>
  void jacobian(const T& t, const T* y, J&& j) const {
    using std::sqrt;
    j(0, 0) = T(0), j(0, 1) = T(1);
    j(1, 0) = T(0), j(1, 1) = y[1] / (sqrt(1 + y[1] * y[1]) * (T(distance) - t));
  }
  /// The exact flow: y0 is the state at t = 0. y' + sqrt(1 + y'^2) grows like 1/(distance - t).
  template <class T>
  void exact(const T& t, const T* start, T* y) const {
    using std::log, std::sqrt;
    const T D(distance), left = D - t, p = start[1] + sqrt(1 + start[1] * start[1]), q = p * D / left;
    y[0] = start[0] + (D * p * log(D / left) - t * (D + left) / (2 * D * p)) / 2;
    y[1] = (q - 1 / q) / 2;
  }
};

}  // namespace odemark
