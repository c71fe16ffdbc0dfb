// The linear test equation: what stability functions and stability regions are about.
#pragma once
#include "problems/family.hpp"

namespace odemark {

/// y' = lambda y for complex y and lambda; the state is (Re y, Im y).
template <class Real = double>
struct Dahlquist {
  static constexpr std::string_view id = "dahlquist";
  static constexpr std::string_view title = "Linear test equation";
  static constexpr std::string_view equations =
      "re' = lambda_re re - lambda_im im;  im' = lambda_im re + lambda_re im";
  static constexpr std::string_view source = "G. Dahlquist, BIT 3 (1963) 27-43, doi:10.1007/BF01963532";
  static constexpr std::size_t size = 2;
  static constexpr std::array<Component, size> components{{{"re", ""}, {"im", ""}}};

  Real lambda_re = -1, lambda_im = 0, t_end = 10;

  static constexpr auto parameters() {
    using P = Parameter<Dahlquist, Real>;
    return std::array{P{"lambda_re", "1/s", "growth rate, negative to decay", &Dahlquist::lambda_re},
                      P{"lambda_im", "rad/s", "angular frequency", &Dahlquist::lambda_im},
                      P{"t_end", "s", "end of the interval", &Dahlquist::t_end, positive}};
  }
  static constexpr std::array presets{
      Preset{"dahlquist", "", "decay, lambda = -1"},
      Preset{"dahlquist_rotation", "lambda_re=0,lambda_im=1",
             "on the imaginary axis: nothing may grow or fade"},
      Preset{"dahlquist_spiral", "lambda_re=-0.125,lambda_im=1", "a damped oscillation"},
      Preset{"dahlquist_stiff", "lambda_re=-1000,t_end=1", "the transient is over after a few milliseconds"},
      Preset{"dahlquist_detest_a1", "t_end=20", "DETEST A1: the same decay for longer"}};

  std::array<double, size> scale() const { return {1, 1}; }
  double suggested_dt() const {
    const double rate = std::hypot(double(lambda_re), double(lambda_im));
    return rate > 0 ? 0.05 / rate : 0.05;
  }

  template <class T>
  void initial(T* y) const {
    y[0] = T(1), y[1] = T(0);
  }
  template <class T>
  void rhs(const T&, const T* y, T* dydt) const {
    dydt[0] = T(lambda_re) * y[0] - T(lambda_im) * y[1];
    dydt[1] = T(lambda_im) * y[0] + T(lambda_re) * y[1];
  }
  template <class T, class J>
  void jacobian(const T&, const T*, J&& j) const {
    linear_part<T>(j);
  }
  template <class T, class L>
  void linear_part(L&& l) const {
    l(0, 0) = T(lambda_re), l(0, 1) = -T(lambda_im);
    l(1, 0) = T(lambda_im), l(1, 1) = T(lambda_re);
  }
  /// The same system with every drive removed: 0 is its fixed point.
  Dahlquist homogeneous() const { return *this; }

  /// The exact flow: y0 is the state at t = 0.
  template <class T>
  void exact(const T& t, const T* y0, T* y) const {
    using std::cos, std::exp, std::sin;
    const T growth = exp(T(lambda_re) * t);
    const T c = growth * cos(T(lambda_im) * t), s = growth * sin(T(lambda_im) * t);
    y[0] = c * y0[0] - s * y0[1];
    y[1] = s * y0[0] + c * y0[1];
  }
};

}  // namespace odemark
