// A stiff scalar that follows a slow drive: where methods lose order although nothing fast is to be seen.
#pragma once
#include <algorithm>

#include "problems/family.hpp"

namespace odemark {

template <class Real = double>
struct ProtheroRobinson {
  static constexpr std::string_view id = "prothero_robinson";
  static constexpr std::string_view title = "Prothero-Robinson problem";
  static constexpr std::string_view equations =
      "y' = lambda (y - drive phi) + drive phi',  phi = 10 - (10 + t) exp(-t)";
  static constexpr std::string_view source =
      "A. Prothero, A. Robinson, Math. Comp. 28 (1974) 145-162, doi:10.1090/S0025-5718-1974-0331793-2";
  static constexpr std::size_t size = 1;
  static constexpr std::array<Component, size> components{{{"y", ""}}};

  Real lambda = -1000, drive = 1, y0 = 0, t_end = 10;

  static constexpr auto parameters() {
    using P = Parameter<ProtheroRobinson, Real>;
    return std::array{P{"lambda", "1/s", "rate at which y is drawn to the drive", &ProtheroRobinson::lambda,
                        Range{.highest = 0, .open_above = true}},
                      P{"drive", "", "strength of the drive", &ProtheroRobinson::drive},
                      P{"y0", "", "initial value; 0 is on the smooth solution", &ProtheroRobinson::y0},
                      P{"t_end", "s", "end of the interval", &ProtheroRobinson::t_end, positive}};
  }
  static constexpr std::array presets{
      Preset{"prothero_robinson", "", "lambda = -1000: order reduction begins to show"},
      Preset{"prothero_robinson_mild", "lambda=-10", "hardly stiff: classical orders"},
      Preset{"prothero_robinson_stiff", "lambda=-1e6", "stage orders alone count"},
      Preset{"prothero_robinson_transient", "lambda=-1000,y0=1,t_end=1",
             "starts off the smooth solution: a jump to follow or to damp"}};

  std::array<double, size> scale() const {
    const double size_of = std::max(10 * std::abs(double(drive)), std::abs(double(y0)));
    return {size_of > 0 ? size_of : 1};
  }
  double suggested_dt() const { return 0.05 / std::max(1.0, -double(lambda)); }

  template <class T>
  void initial(T* y) const {
    y[0] = T(y0);
  }
  template <class T>
  void rhs(const T& t, const T* y, T* dydt) const {
    using std::exp;
    const T fading = exp(-t);
    dydt[0] = T(lambda) * (y[0] - T(drive) * (10 - (10 + t) * fading)) + T(drive) * ((9 + t) * fading);
  }
  template <class T, class J>
  void jacobian(const T&, const T*, J&& j) const {
    linear_part<T>(j);
  }
  template <class T, class L>
  void linear_part(L&& l) const {
    l(0, 0) = T(lambda);
  }
  /// The same system with every drive removed: 0 is its fixed point.
  ProtheroRobinson homogeneous() const {
    ProtheroRobinson undriven = *this;
    undriven.drive = 0;
    return undriven;
  }
  /// The exact flow: y0 is the state at t = 0.
  template <class T>
  void exact(const T& t, const T* start, T* y) const {
    using std::exp;
    y[0] = T(drive) * (10 - (10 + t) * exp(-t)) + start[0] * exp(T(lambda) * t);
  }
};

}  // namespace odemark
