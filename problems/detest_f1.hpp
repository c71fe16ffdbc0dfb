// F1 of DETEST: an unstable oscillation, pushed to and fro each second.
#pragma once
#include <algorithm>

#include "problems/elliptic.hpp"
#include "problems/family.hpp"
#include "problems/unit_pieces.hpp"

namespace odemark {

template <class Real = double>
struct DetestF1 {
  static constexpr std::string_view id = "detest_f1";
  static constexpr std::string_view title = "Oscillation under a square wave (DETEST F1)";
  static constexpr std::string_view equations =
      "y1' = y2;  y2' = 2 a y2 - (pi^2 + a^2) y1 + s,  s = 1 in even seconds, -1 in odd ones";
  static constexpr std::string_view source =
      "F1 of DETEST, W. H. Enright, J. D. Pryce, ACM Trans. Math. Softw. 13 (1987) 1-27, "
      "doi:10.1145/23002.27645";
  static constexpr std::size_t size = 2;
  static constexpr std::array<Component, size> components{{{"y1", ""}, {"y2", "1/s"}}};
  static constexpr bool force_depends_on_velocity = true;

  Real a = Real(1) / 10, t_end = 20;
  UnitPieces pieces;

  static constexpr auto parameters() {
    using P = Parameter<DetestF1, Real>;
    return std::array{P{"a", "1/s", "growth rate", &DetestF1::a},
                      P{"t_end", "s", "end of the interval", &DetestF1::t_end,
                        Range{.lowest = 0, .highest = 1000, .open_below = true}}};
  }
  static constexpr std::array presets{
      Preset{"detest_f1", "", "as published: each push comes when it makes the oscillation larger"},
      Preset{"detest_f1_damped", "a=-0.125,t_end=10", "the same with damping: nearly periodic at the end"}};

  std::array<double, size> scale() const {
    const double grown =
        a == 0 ? double(t_end) : std::expm1(double(a) * double(t_end)) / std::expm1(double(a));
    const double x = (1 + std::exp(double(a))) / double(stiffness()) * std::max(grown, 1.0);
    return {x, double(pi()) * x};
  }
  double suggested_dt() const { return 1.0 / 64; }
  std::vector<double> switch_times() const { return UnitPieces::switches_before(double(t_end)); }
  DetestF1 during(std::size_t phase) const {
    DetestF1 held = *this;
    held.pieces.held = int(phase);
    return held;
  }
  template <class T>
  void initial(T* y) const {
    y[0] = T(0), y[1] = T(0);
  }
  template <class T>
  void acceleration(const T& t, const T* y, T* force) const {
    force[0] = 2 * T(a) * y[1] - T(stiffness()) * y[0] + T(push(pieces.at(t)));
  }
  template <class T>
  void rhs(const T& t, const T* y, T* dydt) const {
    dydt[0] = y[1];
    acceleration(t, y, &dydt[1]);
  }
  template <class T, class J>
  void jacobian(const T&, const T*, J&& j) const {
    linear_part<T>(j);
  }
  template <class T, class L>
  void linear_part(L&& l) const {
    l(0, 0) = T(0), l(0, 1) = T(1);
    l(1, 0) = -T(stiffness()), l(1, 1) = 2 * T(a);
  }
  /// The exact flow: y0 is the state at t = 0. Eigenvalues a +- i pi, about push/(pi^2 + a^2).
  template <class T>
  void exact(const T& t, const T* y0, T* y) const {
    using std::cos, std::exp, std::sin, std::sqrt;
    const T w2 = T(stiffness()), growth = T(a), w = sqrt(w2 - growth * growth);
    const int last = UnitPieces{}.at(t);
    y[0] = y0[0], y[1] = y0[1];
    for (int piece = 0; piece <= last; ++piece) {
      const T tau = piece < last ? T(1) : T(t - T(last)), rest = T(push(piece)) / w2;
      const T z = y[0] - rest, v = y[1], e = exp(growth * tau), c = cos(w * tau), s = sin(w * tau) / w;
      y[0] = rest + e * (z * c + (v - growth * z) * s);
      y[1] = e * (v * c + (growth * v - w2 * z) * s);
    }
  }

 private:
  static Real pi() { return elliptic::pi<Real>(); }
  Real stiffness() const { return pi() * pi() + a * a; }
  static int push(int piece) { return piece % 2 == 0 ? 1 : -1; }
};

}  // namespace odemark
