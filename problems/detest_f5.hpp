// F5 of DETEST: cusps: the derivative of the slope is infinite nineteen times.
#pragma once
#include "problems/family.hpp"
#include "problems/unit_pieces.hpp"

namespace odemark {

template <class Real = double>
struct DetestF5 {
  static constexpr std::string_view id = "detest_f5";
  static constexpr std::string_view title = "Nineteen cusps (DETEST F5)";
  static constexpr std::string_view equations =
      "y' = 4/(3 c) y sum_i sign(t - i) |t - i|^(1/3),  c = sum_i i^(4/3),  i = 1 ... 19";
  static constexpr std::string_view source =
      "F5 of DETEST, W. H. Enright, J. D. Pryce, ACM Trans. Math. Softw. 13 (1987) 1-27, "
      "doi:10.1145/23002.27645";
  static constexpr std::size_t size = 1;
  static constexpr std::array<Component, size> components{{{"y", ""}}};

  Real y0 = 1, t_end = 20;
  UnitPieces pieces;

  static constexpr auto parameters() {
    using P = Parameter<DetestF5, Real>;
    return std::array{P{"y0", "", "initial value", &DetestF5::y0},
                      P{"t_end", "s", "end of the interval", &DetestF5::t_end,
                        Range{.lowest = 0, .highest = 1000, .open_below = true}}};
  }
  static constexpr std::array presets{
      Preset{"detest_f5", "", "as published: the slope itself does not jump; y(20) = y(0)"}};

  std::array<double, size> scale() const { return {y0 == 0 ? 1.0 : std::abs(double(y0))}; }
  double suggested_dt() const { return 1.0 / 64; }
  std::vector<double> switch_times() const { return UnitPieces::switches_before(double(t_end)); }
  DetestF5 during(std::size_t phase) const {
    DetestF5 held = *this;
    held.pieces.held = int(phase);
    return held;
  }
  template <class T>
  void initial(T* y) const {
    y[0] = T(y0);
  }
  template <class T>
  void rhs(const T& t, const T* y, T* dydt) const {
    dydt[0] = rate(t) * y[0];
  }
  template <class T, class J>
  void jacobian(const T& t, const T*, J&& j) const {
    j(0, 0) = rate(t);
  }
  /// The exact flow: y0 is the state at t = 0.
  template <class T>
  void exact(const T& t, const T* from, T* y) const {
    using std::abs, std::exp;
    T sum = 0, start = 0;
    for (int i = 1; i <= cusps; ++i) {
      const T u = abs(t - T(i));
      sum += u * cube_root(u), start += T(i) * cube_root(T(i));
    }
    y[0] = from[0] * exp(T(factor()) * (sum - start) * 3 / 4);
  }

 private:
  static constexpr int cusps = 19;
  /// 4/(3 c), rounded where the parameters are.
  static Real factor() {
    Real sum = 0;
    for (int i = 1; i <= cusps; ++i) sum += Real(i) * cube_root(Real(i));
    return 4 / (3 * sum);
  }
  template <class T>
  static T cube_root(const T& x) {
    using std::exp, std::log;
    if constexpr (requires { bool(x == T(0)); })
      if (x == T(0)) return T(0);
    return exp(log(x) / 3);
  }
  template <class T>
  T rate(const T& t) const {
    T sum(0);
    const int begun = pieces.at(t);
    for (int i = 1; i <= cusps; ++i) {
      if (i <= begun)
        sum += cube_root(T(t - T(i)));
      else
        sum -= cube_root(T(T(i) - t));
    }
    return T(factor()) * sum;
  }
};

}  // namespace odemark
