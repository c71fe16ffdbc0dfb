// Two pendulums on each other: regular when small, chaotic when not.
#pragma once
#include <algorithm>

#include "problems/family.hpp"

namespace odemark {

/// State (a, b, wa, wb): angles from hanging and their rates; point masses on rods without mass.
template <class Real = double>
struct DoublePendulum {
  static constexpr std::string_view id = "double_pendulum";
  static constexpr std::string_view title = "Double pendulum";
  static constexpr std::string_view equations =
      "l1 a'' + m l2 (b'' cos(a-b) + b'^2 sin(a-b)) = -g sin a;  l2 b'' + l1 (a'' cos(a-b) - a'^2 sin(a-b)) "
      "= -g "
      "sin b,  m = m2/(m1 + m2)";
  static constexpr std::string_view source =
      "T. Shinbrot, C. Grebogi, J. Wisdom, J. A. Yorke, Am. J. Phys. 60 (1992) 491-499, doi:10.1119/1.16860";
  static constexpr std::size_t size = 4;
  static constexpr std::array<Component, size> components{
      {{"a", "rad"}, {"b", "rad"}, {"wa", "rad/s"}, {"wb", "rad/s"}}};
  static constexpr std::array<std::string_view, 1> invariant_names{"energy"};
  static constexpr bool force_depends_on_velocity = true;

  Real m1 = 1, m2 = 1, l1 = 1, l2 = 1, g = Real(157) / 16, a0 = 2, b0 = Real(5) / 2, t_end = 5;

  static constexpr auto parameters() {
    using P = Parameter<DoublePendulum, Real>;
    return std::array{P{"m1", "kg", "upper mass", &DoublePendulum::m1, positive},
                      P{"m2", "kg", "lower mass", &DoublePendulum::m2, positive},
                      P{"l1", "m", "length of the upper rod", &DoublePendulum::l1, positive},
                      P{"l2", "m", "length of the lower rod", &DoublePendulum::l2, positive},
                      P{"g", "m/s^2", "gravity", &DoublePendulum::g, positive},
                      P{"a0", "rad", "initial angle of the upper rod", &DoublePendulum::a0},
                      P{"b0", "rad", "initial angle of the lower rod", &DoublePendulum::b0},
                      P{"t_end", "s", "end of the interval", &DoublePendulum::t_end, positive}};
  }
  static constexpr std::array presets{
      Preset{"double_pendulum", "", "chaotic; ends where doubles still can know the answer"},
      Preset{"double_pendulum_small", "a0=0.25,b0=0.25,t_end=10", "two slow beats, regular for ever"},
      Preset{"double_pendulum_light", "m2=1/16,a0=1,b0=-1,t_end=5", "a light lower mass is flung about"}};

  std::array<double, size> scale() const {
    const double w = std::sqrt(double(g) / std::min(double(l1), double(l2)));
    return {1, 1, w, w};
  }
  double suggested_dt() const { return 0.0078125 * std::sqrt(std::min(double(l1), double(l2)) / double(g)); }

  template <class T>
  void initial(T* y) const {
    y[0] = T(a0), y[1] = T(b0), y[2] = T(0), y[3] = T(0);
  }
  template <class T>
  void acceleration(const T&, const T* y, T* a) const {
    using std::cos, std::sin;
    const T share = T(m2) / (T(m1) + T(m2)), s = sin(y[0] - y[1]), c = cos(y[0] - y[1]);
    const T upper = -share * T(l2) * y[3] * y[3] * s - T(g) * sin(y[0]);
    const T lower = T(l1) * y[2] * y[2] * s - T(g) * sin(y[1]);
    const T below = 1 - share * c * c;
    a[0] = (upper - share * c * lower) / (T(l1) * below);
    a[1] = (lower - c * upper) / (T(l2) * below);
  }
  template <class T>
  void rhs(const T& t, const T* y, T* dydt) const {
    dydt[0] = y[2], dydt[1] = y[3];
    acceleration(t, y, &dydt[2]);
  }
  template <class T>
  void invariants(const T* y, T* out) const {
    using std::cos;
    const T va = T(l1) * y[2], vb = T(l2) * y[3], both = T(m1) + T(m2);
    out[0] = both * va * va / 2 + T(m2) * (vb * vb / 2 + va * vb * cos(y[0] - y[1])) -
             T(g) * (both * T(l1) * cos(y[0]) + T(m2) * T(l2) * cos(y[1]));
  }
};

}  // namespace odemark
