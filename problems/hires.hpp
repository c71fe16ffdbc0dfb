// High irradiance response of plants: eight species, moderately stiff, one product of two of them.
#pragma once
#include "problems/family.hpp"

namespace odemark {

/// State: concentrations of phytochrome and its partners. y7 and y8 share a fixed total.
template <class Real = double>
struct Hires {
  static constexpr std::string_view id = "hires";
  static constexpr std::string_view title = "HIRES, light response of a plant";
  static constexpr std::string_view equations =
      "y1' = -1.71 y1 + 0.43 y2 + 8.32 y3 + feed;  y2' = 1.71 y1 - 8.75 y2;  y3' = -10.03 y3 + 0.43 y4 + "
      "0.035 "
      "y5;  y4' = 8.32 y2 + 1.71 y3 - 1.12 y4;  y5' = -1.745 y5 + 0.43 (y6 + y7);  y6' = -k y6 y8 + 0.69 y4 "
      "+ "
      "1.71 y5 - 0.43 y6 + 0.69 y7;  y7' = k y6 y8 - 1.81 y7;  y8' = -y7'";
  static constexpr std::string_view source =
      "E. Schafer, J. Math. Biol. 2 (1975) 41-56, doi:10.1007/BF00276015; F. Mazzia, C. Magherini, Test Set "
      "for "
      "Initial Value Problem Solvers, release 2.4 (2008), problem hires";
  static constexpr std::size_t size = 8;
  static constexpr std::array<Component, size> components{
      {{"y1", ""}, {"y2", ""}, {"y3", ""}, {"y4", ""}, {"y5", ""}, {"y6", ""}, {"y7", ""}, {"y8", ""}}};
  static constexpr std::array<std::string_view, 1> invariant_names{"complex_total"};

  Real feed = Real(7) / 10000, k = 280, y8 = Real(57) / 10000, t_end = Real(3218122) / 10000;

  static constexpr auto parameters() {
    using P = Parameter<Hires, Real>;
    return std::array{P{"feed", "", "constant supply of y1", &Hires::feed, not_negative},
                      P{"k", "", "rate of 6 + 8 -> 7", &Hires::k, not_negative},
                      P{"y8", "", "initial y8", &Hires::y8, not_negative},
                      P{"t_end", "", "end of the interval", &Hires::t_end, positive}};
  }
  static constexpr std::array presets{
      Preset{"hires", "", "ends on the steep transient in which the complex falls apart"}};

  /// Sizes at the end; y1 starts at 1 and y6 passes through 0.7.
  std::array<double, size> scale() const { return {1e-3, 2e-4, 1e-4, 1e-3, 2e-3, 6e-3, 3e-3, 3e-3}; }
  double suggested_dt() const { return 0.01; }

  template <class T>
  void initial(T* y) const {
    for (std::size_t i = 0; i < size; ++i) y[i] = T(0);
    y[0] = T(1), y[7] = T(y8);
  }
  template <class T>
  void rhs(const T&, const T* y, T* dydt) const {
    const T bound = T(k) * y[5] * y[7] - rate<T>(181, 100) * y[6];
    dydt[0] = T(feed) - rate<T>(171, 100) * y[0] + rate<T>(43, 100) * y[1] + rate<T>(832, 100) * y[2];
    dydt[1] = rate<T>(171, 100) * y[0] - rate<T>(875, 100) * y[1];
    dydt[2] = rate<T>(43, 100) * y[3] + rate<T>(35, 1000) * y[4] - rate<T>(1003, 100) * y[2];
    dydt[3] = rate<T>(832, 100) * y[1] + rate<T>(171, 100) * y[2] - rate<T>(112, 100) * y[3];
    dydt[4] = rate<T>(43, 100) * (y[5] + y[6]) - rate<T>(1745, 1000) * y[4];
    dydt[5] = rate<T>(69, 100) * y[3] + rate<T>(171, 100) * y[4] - rate<T>(43, 100) * y[5] +
              rate<T>(69, 100) * y[6] - T(k) * y[5] * y[7];
    dydt[6] = bound;
    dydt[7] = -bound;
  }
  template <class T, class J>
  void jacobian(const T&, const T* y, J&& j) const {
    for (std::size_t column = 0; column < size; ++column)
      for (std::size_t row = 0; row < size; ++row) j(row, column) = T(0);
    const T by6 = T(k) * y[7], by8 = T(k) * y[5];
    j(0, 0) = -rate<T>(171, 100), j(0, 1) = rate<T>(43, 100), j(0, 2) = rate<T>(832, 100);
    j(1, 0) = rate<T>(171, 100), j(1, 1) = -rate<T>(875, 100);
    j(2, 2) = -rate<T>(1003, 100), j(2, 3) = rate<T>(43, 100), j(2, 4) = rate<T>(35, 1000);
    j(3, 1) = rate<T>(832, 100), j(3, 2) = rate<T>(171, 100), j(3, 3) = -rate<T>(112, 100);
    j(4, 4) = -rate<T>(1745, 1000), j(4, 5) = rate<T>(43, 100), j(4, 6) = rate<T>(43, 100);
    j(5, 3) = rate<T>(69, 100), j(5, 4) = rate<T>(171, 100), j(5, 5) = -rate<T>(43, 100) - by6;
    j(5, 6) = rate<T>(69, 100), j(5, 7) = -by8;
    j(6, 5) = by6, j(6, 6) = -rate<T>(181, 100), j(6, 7) = by8;
    j(7, 5) = -by6, j(7, 6) = rate<T>(181, 100), j(7, 7) = -by8;
  }
  template <class T>
  void invariants(const T* y, T* out) const {
    out[0] = y[6] + y[7];
  }

 private:
  /// Published with two or three decimals; rounded where the parameters are.
  template <class T>
  static T rate(int numerator, int denominator) {
    return T(Real(numerator) / Real(denominator));
  }
};

}  // namespace odemark
