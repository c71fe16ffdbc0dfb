// A joint held by a PD law through a motor that lags: a stiff loop that the lag can make unstable.
#pragma once
#include <algorithm>

#include "problems/family.hpp"

namespace odemark {

/// State (theta, w, torque). The loop is stable while lag < kd/kp.
template <class Real = double>
struct PdServo {
  static constexpr std::string_view id = "pd_servo";
  static constexpr std::string_view title = "PD servo behind a motor lag";
  static constexpr std::string_view equations =
      "theta' = w;  w' = torque/I;  lag torque' = kp (target - theta) - kd w - torque";
  static constexpr std::string_view source =
      "K. J. Astrom, R. M. Murray, Feedback Systems (Princeton, 2008), ch. 10; the limit is A. Hurwitz's, "
      "Math. Ann. 46 "
      "(1895) 273-284, doi:10.1007/BF01446812";
  static constexpr std::size_t size = 3;
  static constexpr std::array<Component, size> components{
      {{"theta", "rad"}, {"w", "rad/s"}, {"torque", "N m"}}};

  Real I = Real(1) / 32768, kp = 2, kd = Real(1) / 128, lag = Real(1) / 1024, target = 1, t_end = Real(1) / 8;

  static constexpr auto parameters() {
    using P = Parameter<PdServo, Real>;
    return std::array{P{"I", "kg m^2", "inertia of the joint", &PdServo::I, positive},
                      P{"kp", "N m/rad", "stiffness of the law", &PdServo::kp, positive},
                      P{"kd", "N m s/rad", "damping of the law", &PdServo::kd, not_negative},
                      P{"lag", "s", "time constant of the motor", &PdServo::lag, positive},
                      P{"target", "rad", "angle that is asked for", &PdServo::target},
                      P{"t_end", "s", "end of the interval", &PdServo::t_end, positive}};
  }
  static constexpr std::array presets{
      Preset{"pd_servo", "", "a small servo of 256 rad/s takes a step of 1 rad"},
      Preset{"pd_servo_lagging", "lag=3/1024", "three quarters of the lag that is allowed: rings for long"},
      Preset{"pd_servo_unstable", "lag=5/1024", "beyond the limit: the true loop oscillates ever wilder"}};

  std::array<double, size> scale() const {
    const double angle = std::max(std::abs(double(target)), 1e-3);
    return {angle, angle * std::sqrt(double(kp) / double(I)), angle * double(kp)};
  }
  double suggested_dt() const {
    return 0.0625 * std::min(double(lag) * 4, std::sqrt(double(I) / double(kp)));
  }

  template <class T>
  void initial(T* y) const {
    y[0] = T(0), y[1] = T(0), y[2] = T(0);
  }
  template <class T>
  void rhs(const T&, const T* y, T* dydt) const {
    dydt[0] = y[1];
    dydt[1] = y[2] / T(I);
    dydt[2] = (T(kp) * (T(target) - y[0]) - T(kd) * y[1] - y[2]) / T(lag);
  }
  template <class T, class J>
  void jacobian(const T&, const T*, J&& j) const {
    linear_part<T>(j);
  }
  template <class T, class L>
  void linear_part(L&& l) const {
    l(0, 0) = T(0), l(0, 1) = T(1), l(0, 2) = T(0);
    l(1, 0) = T(0), l(1, 1) = T(0), l(1, 2) = 1 / T(I);
    l(2, 0) = -T(kp) / T(lag), l(2, 1) = -T(kd) / T(lag), l(2, 2) = -1 / T(lag);
  }
  /// The same system with every drive removed: 0 is its fixed point.
  PdServo homogeneous() const {
    PdServo still = *this;
    still.target = 0;
    return still;
  }
};

}  // namespace odemark
