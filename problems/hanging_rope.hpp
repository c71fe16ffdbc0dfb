// A light rope with a heavy load: the rope of every game, and why it needs so many substeps.
#pragma once
#include <algorithm>

#include "problems/family.hpp"
#include "problems/numbered.hpp"

namespace odemark {

/// State (x1 .. x10, y1 .. y10, vx1 .. vx10, vy1 .. vy10), y upwards from where it hangs. The load is at node
/// 10; the fastest vibration is near 2 sqrt(k/m), whatever the load. Starts at rest, straight, at an angle,
/// every link stretched by the load.
template <class Real = double>
struct HangingRope {
  static constexpr std::string_view id = "hanging_rope";
  static constexpr std::string_view title = "Hanging rope with a heavy load";
  static constexpr std::string_view equations =
      "mi ri'' = T(i+1) - T(i) - mi g e_y,  T(i) = k (|di| - l) di/|di|,  di = ri - r(i-1), r0 = 0, T(11) = "
      "0";
  static constexpr std::string_view source =
      "ours: masses and springs as of X. Provot, Graphics Interface (1995) 147-154, with the load of a crane";
  static constexpr std::size_t links = 10, size = 4 * links;
  static constexpr auto components = joined(numbered<"x", links>("m"), numbered<"y", links>("m"),
                                            numbered<"vx", links>("m/s"), numbered<"vy", links>("m/s"));
  static constexpr std::array<std::string_view, 1> invariant_names{"energy"};
  static constexpr bool force_depends_on_velocity = false;

  Real m = Real(1) / 8, load = 100, k = 1048576, l = Real(1) / 8, g = Real(157) / 16, slope = Real(1) / 4,
       t_end = Real(1) / 32;

  static constexpr auto parameters() {
    using P = Parameter<HangingRope, Real>;
    return std::array{P{"m", "kg", "mass of a link", &HangingRope::m, positive},
                      P{"load", "kg", "mass at the end", &HangingRope::load, positive},
                      P{"k", "N/m", "stiffness of a link", &HangingRope::k, positive},
                      P{"l", "m", "length of a link", &HangingRope::l, positive},
                      P{"g", "m/s^2", "gravity", &HangingRope::g, positive},
                      P{"slope", "", "tangent of the initial angle from hanging", &HangingRope::slope},
                      P{"t_end", "s", "end of the interval", &HangingRope::t_end, positive}};
  }
  static constexpr std::array presets{
      Preset{"hanging_rope", "", "0.7 % of stretch: 5800 rad/s on a swing of 3; two frames of 60 Hz"}};

  std::array<double, size> scale() const {
    const double length = double(links) * double(l), v = std::sqrt(double(g) * length);
    std::array<double, size> all;
    for (std::size_t i = 0; i < size; ++i) all[i] = i < size / 2 ? length : v;
    return all;
  }
  double suggested_dt() const { return 0.0625 * std::sqrt(double(m) / double(k)); }

  template <class T>
  void initial(T* y) const {
    using std::sqrt;
    const T down = (T(l) + T(load) * T(g) / T(k)) / sqrt(1 + T(slope) * T(slope)), x = down * T(slope);
    for (std::size_t i = 0; i < links; ++i) {
      const T number = T(int(i) + 1);
      y[i] = number * x, y[links + i] = -(number * down);
      y[2 * links + i] = T(0), y[3 * links + i] = T(0);
    }
  }
  template <class T>
  void acceleration(const T&, const T* y, T* a) const {
    using std::sqrt;
    for (std::size_t i = 0; i < links; ++i) a[i] = T(0), a[links + i] = -T(g);
    for (std::size_t i = 0; i < links; ++i) {
      const T dx = i == 0 ? y[0] : T(y[i] - y[i - 1]),
              dy = i == 0 ? y[links] : T(y[links + i] - y[links + i - 1]);
      const T pull = T(k) * (T(l) / sqrt(dx * dx + dy * dy) - 1);
      const T mass = i + 1 == links ? T(load) : T(m);
      a[i] += pull * dx / mass, a[links + i] += pull * dy / mass;
      if (i > 0) a[i - 1] -= pull * dx / T(m), a[links + i - 1] -= pull * dy / T(m);
    }
  }
  template <class T>
  void rhs(const T& t, const T* y, T* dydt) const {
    for (std::size_t i = 0; i < size / 2; ++i) dydt[i] = y[i + size / 2];
    acceleration(t, y, dydt + size / 2);
  }
  template <class T>
  void invariants(const T* y, T* out) const {
    using std::sqrt;
    T energy = T(0);
    for (std::size_t i = 0; i < links; ++i) {
      const T dx = i == 0 ? y[0] : T(y[i] - y[i - 1]),
              dy = i == 0 ? y[links] : T(y[links + i] - y[links + i - 1]);
      const T stretch = sqrt(dx * dx + dy * dy) - T(l), mass = i + 1 == links ? T(load) : T(m);
      const T vx = y[2 * links + i], vy = y[3 * links + i];
      energy += mass * ((vx * vx + vy * vy) / 2 + T(g) * y[links + i]) + T(k) * stretch * stretch / 2;
    }
    out[0] = energy;
  }
};

}  // namespace odemark
