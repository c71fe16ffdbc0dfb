// F2 of DETEST: decay whose rate jumps each second.
#pragma once
#include <algorithm>

#include "problems/family.hpp"
#include "problems/unit_pieces.hpp"

namespace odemark {

template <class Real = double>
struct DetestF2 {
  static constexpr std::string_view id = "detest_f2";
  static constexpr std::string_view title = "Decay with a rate that jumps (DETEST F2)";
  static constexpr std::string_view equations = "y' = 55 - r y,  r = 3/2 in even seconds, 1/2 in odd ones";
  static constexpr std::string_view source =
      "F2 of DETEST, W. H. Enright, J. D. Pryce, ACM Trans. Math. Softw. 13 (1987) 1-27, "
      "doi:10.1145/23002.27645";
  static constexpr std::size_t size = 1;
  static constexpr std::array<Component, size> components{{{"y", ""}}};

  Real supply = 55, even = Real(3) / 2, odd = Real(1) / 2, y0 = 110, t_end = 20;
  UnitPieces pieces;

  static constexpr auto parameters() {
    using P = Parameter<DetestF2, Real>;
    return std::array{P{"supply", "1/s", "constant gain", &DetestF2::supply},
                      P{"even", "1/s", "decay rate in even seconds", &DetestF2::even, positive},
                      P{"odd", "1/s", "decay rate in odd seconds", &DetestF2::odd, positive},
                      P{"y0", "", "initial value", &DetestF2::y0},
                      P{"t_end", "s", "end of the interval", &DetestF2::t_end,
                        Range{.lowest = 0, .highest = 1000, .open_below = true}}};
  }
  static constexpr std::array presets{
      Preset{"detest_f2", "", "as published"},
      Preset{"detest_f2_stiff", "even=100",
             "fast in even seconds, slow in odd ones: stiffness comes and goes"}};

  std::array<double, size> scale() const {
    const double most = std::abs(double(supply)) / std::min(double(even), double(odd));
    return {std::max({std::abs(double(y0)), most, 1e-9})};
  }
  double suggested_dt() const { return 0.0625 / std::max({1.0, double(even), double(odd)}); }
  std::vector<double> switch_times() const { return UnitPieces::switches_before(double(t_end)); }
  DetestF2 during(std::size_t phase) const {
    DetestF2 held = *this;
    held.pieces.held = int(phase);
    return held;
  }
  template <class T>
  void initial(T* y) const {
    y[0] = T(y0);
  }
  template <class T>
  void rhs(const T& t, const T* y, T* dydt) const {
    dydt[0] = T(supply) - rate<T>(pieces.at(t)) * y[0];
  }
  template <class T, class J>
  void jacobian(const T& t, const T*, J&& j) const {
    j(0, 0) = -rate<T>(pieces.at(t));
  }
  /// The exact flow: y0 is the state at t = 0.
  template <class T>
  void exact(const T& t, const T* from, T* y) const {
    using std::exp;
    const int last = UnitPieces{}.at(t);
    y[0] = from[0];
    for (int piece = 0; piece <= last; ++piece) {
      const T tau = piece < last ? T(1) : T(t - T(last)), rest = T(supply) / rate<T>(piece);
      y[0] = rest + (y[0] - rest) * exp(-rate<T>(piece) * tau);
    }
  }

 private:
  template <class T>
  T rate(int piece) const {
    return T(piece % 2 == 0 ? even : odd);
  }
};

}  // namespace odemark
