// A problem that the suite does not have.
#pragma once
#include "problems/family.hpp"

namespace consumer {

template <class Real = double>
struct Logistic {
  static constexpr std::string_view id = "my_logistic";
  static constexpr std::string_view title = "Logistic growth";
  static constexpr std::string_view equations = "x' = r x (1 - x)";
  static constexpr std::string_view source = "P. F. Verhulst, 1838";
  static constexpr std::size_t size = 1;
  static constexpr std::array<odemark::Component, size> components{{{"x", ""}}};

  Real r = 1, x0 = 0.125, t_end = 4;

  static constexpr auto parameters() {
    using P = odemark::Parameter<Logistic, Real>;
    return std::array{P{"r", "1/s", "growth rate", &Logistic::r, odemark::positive},
                      P{"x0", "", "initial share", &Logistic::x0, odemark::positive},
                      P{"t_end", "s", "end of the interval", &Logistic::t_end, odemark::positive}};
  }
  static constexpr std::array presets{odemark::Preset{"my_logistic", "", "from an eighth to nearly all"}};

  std::array<double, size> scale() const { return {1}; }
  double suggested_dt() const { return 0.125 / double(r); }

  template <class T>
  void initial(T* y) const {
    y[0] = T(x0);
  }
  template <class T>
  void rhs(const T&, const T* y, T* dydt) const {
    dydt[0] = T(r) * y[0] * (T(1) - y[0]);
  }
  template <class T>
  void exact(const T& t, const T* y0, T* y) const {
    using std::exp;
    y[0] = y0[0] / (y0[0] + (T(1) - y0[0]) * exp(-T(r) * t));
  }
};

}  // namespace consumer
