// A chain whose rates grow along it: ten distinct eigenvalues, far from orthogonal eigenvectors.
#pragma once
#include "problems/numbered.hpp"

namespace odemark {

/// State: how many of a population have had 0, 1, ... 9 offspring generations (the last: 9 or more).
template <class Real = double>
struct DetestC2 {
  static constexpr std::string_view id = "detest_c2";
  static constexpr std::string_view title = "Chain with growing rates (DETEST C2)";
  static constexpr std::string_view equations =
      "y1' = -k y1;  yi' = k ((i-1) y(i-1) - i yi), i = 2..9;  y10' = 9 k y9;  y1(0) = 1, the others 0";
  static constexpr std::string_view source =
      "C2 of DETEST, T. E. Hull et al., SIAM J. Numer. Anal. 9 (1972) 603-637, doi:10.1137/0709052; the flow "
      "is that of G. U. Yule, Phil. Trans. R. Soc. B 213 (1925) 21-87, doi:10.1098/rstb.1925.0002";
  static constexpr std::size_t size = 10;
  static constexpr std::array<Component, size> components = numbered<"y", size>("");
  static constexpr std::array<std::string_view, 1> invariant_names{"total"};

  Real k = 1, t_end = 20;

  static constexpr auto parameters() {
    using P = Parameter<DetestC2, Real>;
    return std::array{P{"k", "1/s", "rate of the first; the i-th has i times that", &DetestC2::k, positive},
                      P{"t_end", "s", "end of the interval", &DetestC2::t_end, positive}};
  }
  static constexpr std::array presets{Preset{"detest_c2", "", "as published"},
                                      Preset{"detest_c2_short", "t_end=2", "while all ten are alive"}};

  std::array<double, size> scale() const {
    std::array<double, size> one;
    one.fill(1);
    return one;
  }
  double suggested_dt() const { return 0.0078125 / double(k); }

  template <class T>
  void initial(T* y) const {
    for (std::size_t i = 0; i < size; ++i) y[i] = T(i == 0 ? 1 : 0);
  }
  template <class T>
  void rhs(const T&, const T* y, T* dydt) const {
    for (std::size_t i = 0; i < size; ++i) {
      T sum = i + 1 < size ? T(-(T(k) * T(int(i + 1)) * y[i])) : T(0);
      if (i > 0) sum = sum + T(k) * T(int(i)) * y[i - 1];
      dydt[i] = sum;
    }
  }
  template <class T, class J>
  void jacobian(const T&, const T*, J&& j) const {
    linear_part<T>(j);
  }
  template <class T, class L>
  void linear_part(L&& l) const {
    for (std::size_t row = 0; row < size; ++row)
      for (std::size_t column = 0; column < size; ++column)
        l(row, column) = column + 1 == row                 ? T(T(k) * T(int(row)))
                         : column == row && row + 1 < size ? T(-(T(k) * T(int(row + 1))))
                                                           : T(0);
  }
  /// The same system with every drive removed: 0 is its fixed point.
  DetestC2 homogeneous() const { return *this; }

  /// The exact flow: y0 is the state at t = 0. From j the share binomial(i - 1, j - 1) exp(-j k t)
  /// (1 - exp(-k t))^(i - j) comes to i < 10; the rest has gone further.
  template <class T>
  void exact(const T& t, const T* y0, T* y) const {
    using std::exp, std::expm1;
    const T stays = exp(-(T(k) * t)), moves = -expm1(T(-(T(k) * t)));
    T now[size];
    for (std::size_t i = 0; i < size; ++i) now[i] = T(0);
    T power(1);
    for (std::size_t j = 1; j < size; ++j) {
      power = power * stays;
      T share = power, gone(1);
      for (std::size_t i = j; i < size; ++i) {
        now[i - 1] = now[i - 1] + share * y0[j - 1];
        gone = gone - share;
        share = share * moves * int(i) / int(i + 1 - j);
      }
      now[size - 1] = now[size - 1] + gone * y0[j - 1];
    }
    now[size - 1] = now[size - 1] + y0[size - 1];
    for (std::size_t i = 0; i < size; ++i) y[i] = now[i];
  }
  template <class T>
  void invariants(const T* y, T* out) const {
    out[0] = T(0);
    for (std::size_t i = 0; i < size; ++i) out[0] = out[0] + y[i];
  }
};

}  // namespace odemark
