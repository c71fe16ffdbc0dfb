// A motor fed by pulses: an input that switches many times within a frame.
#pragma once
#include <algorithm>
#include <vector>

#include "problems/family.hpp"
#include "problems/plane_flow.hpp"

namespace odemark {

/// State (i, w): current and speed. The voltage is on for the first `duty` of every period.
template <class Real = double>
struct DcMotorPwm {
  static constexpr std::string_view id = "dc_motor_pwm";
  static constexpr std::string_view title = "DC motor fed by pulse width modulation";
  static constexpr std::string_view equations =
      "L i' = u - R i - K w;  J w' = K i - b w,  u = V while f t mod 1 < duty, else 0";
  static constexpr std::string_view source =
      "G. F. Franklin, J. D. Powell, A. Emami-Naeini, Feedback Control of Dynamic Systems, 6th ed. (Pearson, "
      "2010), "
      "2.3; the numbers are those of a small made-up motor";
  static constexpr std::size_t size = 2;
  static constexpr std::array<Component, size> components{{{"i", "A"}, {"w", "rad/s"}}};

  Real R = 1, L = Real(1) / 2048, K = Real(3) / 64, J = Real(1) / 8192, b = Real(1) / 65536, V = 12, f = 1024,
       duty = Real(1) / 2, t_end = Real(31) / 1024;

  static constexpr auto parameters() {
    using P = Parameter<DcMotorPwm, Real>;
    return std::array{P{"R", "ohm", "resistance", &DcMotorPwm::R, positive},
                      P{"L", "H", "inductance", &DcMotorPwm::L, positive},
                      P{"K", "V s", "voltage per speed, and torque per current", &DcMotorPwm::K, positive},
                      P{"J", "kg m^2", "inertia", &DcMotorPwm::J, positive},
                      P{"b", "N m s", "friction", &DcMotorPwm::b, not_negative},
                      P{"V", "V", "supply voltage", &DcMotorPwm::V},
                      P{"f", "Hz", "frequency of the pulses", &DcMotorPwm::f, positive},
                      P{"duty", "", "share of a period that is on", &DcMotorPwm::duty,
                        Range{.lowest = 0, .highest = 1, .open_below = true, .open_above = true}},
                      P{"t_end", "s", "end of the interval", &DcMotorPwm::t_end, positive}};
  }
  static constexpr std::array presets{
      Preset{"dc_motor_pwm", "", "31 periods of 1 kHz: two frames of 60 Hz"},
      Preset{"dc_motor_pwm_slow", "f=64,duty=0.75,t_end=3/64", "pulses as slow as frames: three periods"}};

  std::array<double, size> scale() const {
    const double v = std::max(std::abs(double(V)), 1e-3);
    return {v / double(R), v / double(K)};
  }
  double suggested_dt() const { return std::min(0.25 * double(L) / double(R), 0.125 / double(f)); }

  /// The instants at which the voltage is switched: off, on, off, ...
  std::vector<double> switch_times() const {
    std::vector<double> times;
    for (long n = 0; double(instant(n)) < double(t_end) && n < 10000; ++n)
      times.push_back(double(instant(n)));
    return times;
  }
  /// The smooth problem of phase n: on in the even ones.
  DcMotorPwm during(std::size_t phase) const {
    DcMotorPwm constant = *this;
    constant.held_ = phase % 2 == 0 ? held_on : held_off;
    return constant;
  }

  template <class T>
  void initial(T* y) const {
    y[0] = T(0), y[1] = T(0);
  }
  template <class T>
  void rhs(const T& t, const T* y, T* dydt) const {
    dydt[0] = (voltage(t) - T(R) * y[0] - T(K) * y[1]) / T(L);
    dydt[1] = (T(K) * y[0] - T(b) * y[1]) / T(J);
  }
  template <class T, class M>
  void jacobian(const T&, const T*, M&& j) const {
    linear_part<T>(j);
  }
  template <class T, class M>
  void linear_part(M&& l) const {
    l(0, 0) = -T(R) / T(L), l(0, 1) = -T(K) / T(L), l(1, 0) = T(K) / T(J), l(1, 1) = -T(b) / T(J);
  }
  /// The same system with every drive removed: 0 is its fixed point.
  DcMotorPwm homogeneous() const {
    DcMotorPwm shorted = *this;
    shorted.V = 0;
    return shorted;
  }

  /// The exact flow for t >= 0: y0 is the state at t = 0. From pulse to pulse about the rest under its
  /// voltage.
  template <class T>
  void exact(const T& t, const T* y0, T* y) const {
    const PlaneFlow<T> flow{T(-T(R) / T(L)), T(-T(K) / T(L)), T(T(K) / T(J)), T(-T(b) / T(J))};
    const T below = T(R) * T(b) + T(K) * T(K), rest[2] = {T(V) * T(b) / below, T(V) * T(K) / below};
    T now[2] = {y0[0], y0[1]}, from = T(0);
    for (long n = 0; from < t; ++n) {
      const T until = std::min(T(instant(n)), t), on = n % 2 == 0 ? T(1) : T(0);
      const T off[2] = {now[0] - on * rest[0], now[1] - on * rest[1]};
      flow(T(until - from), off, now);
      now[0] += on * rest[0], now[1] += on * rest[1];
      from = until;
    }
    y[0] = now[0], y[1] = now[1];
  }

 private:
  enum Held { held_not, held_on, held_off };

  Real instant(long n) const { return (Real(int(n / 2)) + (n % 2 == 0 ? duty : Real(1))) / f; }

  /// By doubling and bisection on the instants themselves, so that every number type sees the same switch.
  template <class T>
  T voltage(const T& t) const {
    bool on = held_ == held_on;
    if (held_ == held_not) {
      if constexpr (requires { bool(t < T(Real(0))); }) {
        long below = -1, above = 0;  // instant(below) <= t < instant(above)
        while (!(t < T(instant(above))) && above < (1L << 30)) below = above, above = 2 * above + 1;
        while (above - below > 1) {
          const long middle = below + (above - below) / 2;
          (t < T(instant(middle)) ? above : below) = middle;
        }
        on = above % 2 == 0;
      } else {
        throw std::logic_error("a switch in time cannot be recorded: stop there and use during(phase)");
      }
    }
    return on ? T(V) : T(0);
  }

  Held held_ = held_not;
};

}  // namespace odemark
