// A room with a thermostat: two smooth laws and a band that decides which one holds.
#pragma once
#include "problems/family.hpp"

namespace odemark {

/// State: temperature. The heater starts on, goes off at `high` and on again at `low`.
template <class Real = double>
struct Thermostat {
  static constexpr std::string_view id = "thermostat";
  static constexpr std::string_view title = "Thermostat";
  static constexpr std::string_view equations =
      "y' = (outside - y)/tau + heater power,  heater off at high, on at low";
  static constexpr std::string_view source =
      "T. A. Henzinger, The Theory of Hybrid Automata, in Verification of Digital and Hybrid Systems "
      "(Springer, 2000) "
      "265-292, doi:10.1007/978-3-642-59615-5_13; parameters are ours";
  static constexpr std::size_t size = 1;
  static constexpr std::array<Component, size> components{{{"y", "degC"}}};
  static constexpr std::array<std::string_view, 2> events{"heater off", "heater on"};
  static constexpr std::size_t phase_count = 2;  // heating, cooling

  Real outside = 5, tau = 64, power = Real(1) / 2, low = 19, high = 21, y0 = 15, t_end = 120;
  bool heats = true;

  static constexpr auto parameters() {
    using P = Parameter<Thermostat, Real>;
    return std::array{P{"outside", "degC", "temperature outside", &Thermostat::outside},
                      P{"tau", "min", "time in which the room cools", &Thermostat::tau, positive},
                      P{"power", "degC/min", "what the heater adds", &Thermostat::power, positive},
                      P{"low", "degC", "the heater goes on", &Thermostat::low},
                      P{"high", "degC", "the heater goes off", &Thermostat::high},
                      P{"y0", "degC", "initial temperature", &Thermostat::y0},
                      P{"t_end", "min", "end of the interval", &Thermostat::t_end, positive}};
  }
  static constexpr std::array presets{Preset{"thermostat", "", "two hours, a dozen switches"},
                                      Preset{"thermostat_narrow", "low=19.9375,high=20.0625",
                                             "a band of 1/8 degree: over two hundred switches"}};

  std::string validate() const {
    return outside < low && low < high && y0 < high && high < outside + power * tau
               ? ""
               : "the heater must be able to cross the band from y0, and the cold too: outside < low < high "
                 "< outside + "
                 "power tau, y0 < high";
  }
  std::array<double, size> scale() const { return {double(high)}; }
  double suggested_dt() const { return double(high - low) / double(power) / 32; }
  Thermostat during(std::size_t phase) const {
    Thermostat held = *this;
    held.heats = phase == 0;
    return held;
  }

  template <class T>
  void initial(T* y) const {
    y[0] = T(y0);
  }
  template <class T>
  void rhs(const T&, const T* y, T* dydt) const {
    const T cooling = (T(outside) - y[0]) / T(tau);
    dydt[0] = heats ? T(cooling + T(power)) : cooling;
  }
  template <class T, class J>
  void jacobian(const T&, const T*, J&& j) const {
    linear_part<T>(j);
  }
  template <class T, class L>
  void linear_part(L&& l) const {
    l(0, 0) = -T(1) / T(tau);
  }
  template <class T>
  void event_values(const T&, const T* y, T* value) const {
    value[0] = heats ? T(T(high) - y[0]) : T(1);
    value[1] = heats ? T(1) : T(y[0] - T(low));
  }
  template <class T>
  std::size_t after_event(std::size_t event, const T&, T*) const {
    return event == 0 ? 1 : 0;
  }

  /// The exact flow: y0, below `high`, is the state at t = 0.
  template <class T>
  void exact(const T& t, const T* from, T* y) const {
    exact(t, from, y, [](std::size_t, const T&) {});
  }
  template <class T, class Visit>
  void exact(const T& t, const T* from, T* y, Visit&& visit) const {
    using std::exp, std::log;
    const T cold = T(outside), warm = T(outside) + T(power) * T(tau);
    T begun = 0, now = from[0];
    for (bool on = true;; on = !on) {
      const T aim = on ? warm : cold, turn = on ? T(high) : T(low);
      const T needed = T(tau) * log((aim - now) / (aim - turn));
      if (t - begun < needed) {
        y[0] = aim + (now - aim) * exp(-(t - begun) / T(tau));
        return;
      }
      begun += needed, now = turn;
      visit(on ? 0 : 1, begun);
    }
  }
};

}  // namespace odemark
