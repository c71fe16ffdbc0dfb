// F3 of DETEST: a weak van der Pol oscillator under the absolute value of a sine.
#pragma once
#include "problems/elliptic.hpp"
#include "problems/family.hpp"
#include "problems/unit_pieces.hpp"

namespace odemark {

template <class Real = double>
struct DetestF3 {
  static constexpr std::string_view id = "detest_f3";
  static constexpr std::string_view title = "Oscillator under a rectified sine (DETEST F3)";
  static constexpr std::string_view equations = "y1' = y2;  y2' = mu y2 (1 - y1^2) - y1 - |sin(pi t)|";
  static constexpr std::string_view source =
      "F3 of DETEST, W. H. Enright, J. D. Pryce, ACM Trans. Math. Softw. 13 (1987) 1-27, "
      "doi:10.1145/23002.27645";
  static constexpr std::size_t size = 2;
  static constexpr std::array<Component, size> components{{{"y1", ""}, {"y2", "1/s"}}};
  static constexpr bool force_depends_on_velocity = true;

  Real mu = Real(1) / 100, t_end = 20;
  UnitPieces pieces;

  static constexpr auto parameters() {
    using P = Parameter<DetestF3, Real>;
    return std::array{P{"mu", "1/s", "strength of the damping", &DetestF3::mu},
                      P{"t_end", "s", "end of the interval", &DetestF3::t_end,
                        Range{.lowest = 0, .highest = 1000, .open_below = true}}};
  }
  static constexpr std::array presets{Preset{
      "detest_f3", "", "as published: kinks in the force, so jumps in its derivative, at every second"}};

  std::array<double, size> scale() const { return {1.25, 0.75}; }
  double suggested_dt() const { return 1.0 / 64; }
  std::vector<double> switch_times() const { return UnitPieces::switches_before(double(t_end)); }
  DetestF3 during(std::size_t phase) const {
    DetestF3 held = *this;
    held.pieces.held = int(phase);
    return held;
  }
  template <class T>
  void initial(T* y) const {
    y[0] = T(0), y[1] = T(0);
  }
  template <class T>
  void acceleration(const T& t, const T* y, T* force) const {
    using std::sin;
    const T into = t - T(pieces.at(t));  // a second: the sine of the rest is not negative
    force[0] = T(mu) * y[1] * (1 - y[0] * y[0]) - y[0] - sin(T(elliptic::pi<Real>()) * into);
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
