// Growth that saturates.
#pragma once
#include <algorithm>

#include "problems/family.hpp"

namespace odemark {

template <class Real = double>
struct Logistic {
  static constexpr std::string_view id = "logistic";
  static constexpr std::string_view title = "Logistic growth";
  static constexpr std::string_view equations = "y' = r y (1 - y/K)";
  static constexpr std::string_view source =
      "P.-F. Verhulst, Correspondance mathematique et physique 10 (1838) 113-121; A4 of DETEST, T. E. Hull "
      "et "
      "al., SIAM J. Numer. Anal. 9 (1972) 603-637, doi:10.1137/0709052";
  static constexpr std::size_t size = 1;
  static constexpr std::array<Component, size> components{{{"y", ""}}};

  Real r = 1, K = 1, y0 = Real(1) / 64, t_end = 10;

  static constexpr auto parameters() {
    using P = Parameter<Logistic, Real>;
    return std::array{P{"r", "1/s", "growth rate of a small population", &Logistic::r, positive},
                      P{"K", "", "carrying capacity", &Logistic::K, positive},
                      P{"y0", "", "initial population", &Logistic::y0, positive},
                      P{"t_end", "s", "end of the interval", &Logistic::t_end, positive}};
  }
  static constexpr std::array presets{
      Preset{"logistic", "", "from 1/64 of the capacity: growth, turning point, saturation"},
      Preset{"logistic_detest_a4", "r=0.25,K=20,y0=1,t_end=20", "DETEST A4"},
      Preset{"logistic_crowded", "r=256,y0=4,t_end=0.5",
             "from above, and long after it has settled: steps are bounded by stability alone"}};

  std::array<double, size> scale() const { return {std::max(double(K), double(y0))}; }
  double suggested_dt() const { return 0.03125 / (double(r) * std::max(1.0, double(y0) / double(K))); }

  template <class T>
  void initial(T* y) const {
    y[0] = T(y0);
  }
  template <class T>
  void rhs(const T&, const T* y, T* dydt) const {
    dydt[0] = T(r) * (y[0] * (1 - y[0] / T(K)));
  }
  template <class T, class J>
  void jacobian(const T&, const T* y, J&& j) const {
    j(0, 0) = T(r) * (1 - 2 * (y[0] / T(K)));
  }
  /// The exact flow: y0 is the state at t = 0.
  template <class T>
  void exact(const T& t, const T* start, T* y) const {
    using std::exp;
    const T fading = exp(-T(r) * t);
    y[0] = start[0] / (fading + start[0] / T(K) * (1 - fading));
  }
};

}  // namespace odemark
