// A block on a moving belt, held by a spring: it sticks, breaks away, slips back and sticks again.
#pragma once
#include <algorithm>

#include "problems/elliptic.hpp"
#include "problems/family.hpp"

namespace odemark {

/// State (x, v). While the block sticks it moves with the belt; it slips once the spring pulls harder than
/// static friction holds, and sticks again when it has caught up with the belt. Starts sticking.
template <class Real = double>
struct BeltStickSlip {
  static constexpr std::string_view id = "belt_stick_slip";
  static constexpr std::string_view title = "Stick and slip on a belt";
  static constexpr std::string_view equations =
      "x' = v;  v' = 0 where it sticks, (mu_k N - k x)/m where it slips";
  static constexpr std::string_view source =
      "J. P. Den Hartog, Mechanical Vibrations, 4th ed. (McGraw-Hill, 1956), 7.4; R. I. Leine, D. H. van "
      "Campen, "
      "A. de Kraker, L. van den Steen, Nonlinear Dyn. 16 (1998) 41-54, doi:10.1023/A:1008289604683; "
      "parameters are ours";
  static constexpr std::size_t size = 2;
  static constexpr std::array<Component, size> components{{{"x", "m"}, {"v", "m/s"}}};
  static constexpr std::array<std::string_view, 2> events{"breaks away", "sticks"};
  static constexpr std::size_t phase_count = 2;  // sticking, slipping
  static constexpr bool force_depends_on_velocity = false;

  Real m = 1, k = 16, N = 10, mu_s = Real(3) / 8, mu_k = Real(1) / 4, belt = Real(1) / 8, t_end = 20;
  bool slips = false;

  static constexpr auto parameters() {
    using P = Parameter<BeltStickSlip, Real>;
    return std::array{P{"m", "kg", "mass", &BeltStickSlip::m, positive},
                      P{"k", "N/m", "spring stiffness", &BeltStickSlip::k, positive},
                      P{"N", "N", "normal force", &BeltStickSlip::N, positive},
                      P{"mu_s", "", "coefficient of static friction", &BeltStickSlip::mu_s, positive},
                      P{"mu_k", "", "coefficient of kinetic friction", &BeltStickSlip::mu_k, not_negative},
                      P{"belt", "m/s", "speed of the belt", &BeltStickSlip::belt, positive},
                      P{"t_end", "s", "end of the interval", &BeltStickSlip::t_end, positive}};
  }
  static constexpr std::array presets{
      Preset{"belt_stick_slip", "", "breaks away nine times: 1.25 s sticking, 0.98 s slipping"},
      Preset{"belt_stick_slip_creak", "k=4096,t_end=0.5",
             "a stiff spring: slips of 93 ms with 5 ms of sticking in between"},
      Preset{"belt_stick_slip_slow", "belt=0.0078125,t_end=80",
             "a slow belt: long stillness, and a slip that a large step can miss"}};

  std::string validate() const {
    return mu_k > mu_s ? "kinetic friction mu_k cannot be greater than static friction mu_s" : "";
  }
  std::array<double, size> scale() const {
    const double w = std::sqrt(double(k) / double(m)), away = double(mu_s) * double(N) / double(k);
    return {away, std::hypot(double(belt), w * double(mu_s - mu_k) * double(N) / double(k))};
  }
  double suggested_dt() const { return 0.0625 / std::sqrt(double(k) / double(m)); }
  BeltStickSlip during(std::size_t phase) const {
    BeltStickSlip held = *this;
    held.slips = phase == 1;
    return held;
  }

  template <class T>
  void initial(T* y) const {
    y[0] = T(0), y[1] = T(belt);
  }
  template <class T>
  void acceleration(const T&, const T* y, T* a) const {
    a[0] = slips ? T((T(mu_k * N) - T(k) * y[0]) / T(m)) : T(0);
  }
  template <class T>
  void rhs(const T& t, const T* y, T* dydt) const {
    dydt[0] = y[1];
    acceleration(t, y, &dydt[1]);
  }
  template <class T, class J>
  void jacobian(const T&, const T*, J&& j) const {
    j(0, 0) = T(0), j(0, 1) = T(1);
    j(1, 0) = slips ? T(-T(k) / T(m)) : T(0), j(1, 1) = T(0);
  }
  template <class T>
  void event_values(const T&, const T* y, T* value) const {
    value[0] = slips ? T(1) : T(T(mu_s * N) - T(k) * y[0]);
    value[1] = slips ? T(T(belt) - y[1]) : T(1);
  }
  template <class T>
  std::size_t after_event(std::size_t event, const T&, T* y) const {
    y[1] = T(belt);
    return event == 0 ? 1 : 0;
  }

  /// The exact flow: y0, sticking, is the state at t = 0. A slip starts and ends with the speed of the belt,
  /// and so it is half a swing about mu_k N/k and what makes it symmetric.
  template <class T>
  void exact(const T& t, const T* y0, T* y) const {
    exact(t, y0, y, [](std::size_t, const T&) {});
  }
  template <class T, class Visit>
  void exact(const T& t, const T* y0, T* y, Visit&& visit) const {
    using std::atan, std::cos, std::sin, std::sqrt;
    const T w = sqrt(T(k) / T(m)), away = T(mu_s * N) / T(k), middle = T(mu_k * N) / T(k),
            reach = away - middle;
    const T slipping = 2 * (elliptic::pi<T>() - atan(reach * w / T(belt))) / w;
    T x = y0[0], v = y0[1], begun = 0;
    for (;;) {
      const T sticking = (away - x) / v, stuck = t - begun;
      if (stuck < sticking) {
        y[0] = x + v * stuck, y[1] = v;
        return;
      }
      begun += sticking, v = T(belt);
      visit(0, begun);
      if (const T u = w * (t - begun); t - begun < slipping) {
        y[0] = middle + reach * cos(u) + v / w * sin(u), y[1] = v * cos(u) - reach * w * sin(u);
        return;
      }
      begun += slipping, x = middle - reach;
      visit(1, begun);
    }
  }
};

}  // namespace odemark
