// A ball dropped on ground that pushes back like a stiff spring: contact as most games compute it.
#pragma once
#include <algorithm>

#include "problems/family.hpp"
#include "problems/piecewise.hpp"

namespace odemark {

/// State (x, v): height of the lowest point and its rate. Without loss: it comes back to the height it fell
/// from, and what a method adds or takes at each impact is seen at once.
template <class Real = double>
struct PenaltyContact {
  static constexpr std::string_view id = "penalty_contact";
  static constexpr std::string_view title = "Ball on ground of penalty springs";
  static constexpr std::string_view equations = "x' = v;  v' = -g + k/m max(-x, 0)";
  static constexpr std::string_view source =
      "ours; the penalty method of M. Moore, J. Wilhelms, Computer Graphics (SIGGRAPH) 22 (1988) 289-298, "
      "doi:10.1145/54852.378528";
  static constexpr std::size_t size = 2;
  static constexpr std::array<Component, size> components{{{"x", "m"}, {"v", "m/s"}}};
  static constexpr std::array<std::string_view, 1> invariant_names{"energy"};
  static constexpr bool force_depends_on_velocity = false;

  Real k = 65536, m = 1, g = Real(157) / 16, x0 = 1, v0 = 0, t_end = 5;

  static constexpr auto parameters() {
    using P = Parameter<PenaltyContact, Real>;
    return std::array{P{"k", "N/m", "stiffness of the ground", &PenaltyContact::k, positive},
                      P{"m", "kg", "mass", &PenaltyContact::m, positive},
                      P{"g", "m/s^2", "gravity", &PenaltyContact::g, positive},
                      P{"x0", "m", "initial height", &PenaltyContact::x0},
                      P{"v0", "m/s", "initial speed upwards", &PenaltyContact::v0},
                      P{"t_end", "s", "end of the interval", &PenaltyContact::t_end, positive}};
  }
  static constexpr std::array presets{
      Preset{"penalty_contact", "", "five impacts of 12 ms: less than a step of 60 Hz"},
      Preset{"penalty_contact_soft", "k=64,t_end=6", "impacts of half a second, resolved at any frame rate"}};

  std::array<double, size> scale() const {
    const double height = std::max(std::abs(double(x0)), double(m) * double(g) / double(k));
    return {height, std::max(std::sqrt(2 * double(g) * height), std::abs(double(v0)))};
  }
  double suggested_dt() const { return 0.0625 * std::sqrt(double(m) / double(k)); }

  template <class T>
  void initial(T* y) const {
    y[0] = T(x0), y[1] = T(v0);
  }
  template <class T>
  void acceleration(const T&, const T* y, T* a) const {
    a[0] = T(k) / T(m) * positive_part(T(-y[0])) - T(g);
  }
  template <class T>
  void rhs(const T& t, const T* y, T* dydt) const {
    dydt[0] = y[1];
    acceleration(t, y, &dydt[1]);
  }

  /// The exact flow for t >= 0, flight by flight and contact by contact: y0 is the state at t = 0.
  template <class T>
  void exact(const T& t, const T* y0, T* y) const {
    using std::atan2, std::cos, std::sin, std::sqrt;
    const T w = sqrt(T(k) / T(m)), sag = T(g) / (w * w), turn = 8 * atan2(T(1), T(1));
    T x = y0[0], v = y0[1], left = t;
    for (;;) {
      if (x > 0 || (x == 0 && v > 0)) {
        const T speed = sqrt(v * v + 2 * T(g) * x), landing = (v + speed) / T(g);
        if (left < landing) {
          y[0] = x + v * left - T(g) * left * left / 2;
          y[1] = v - T(g) * left;
          return;
        }
        left -= landing, x = 0, v = -speed;
      }
      // x = R cos(w t + phase) - sag until that is 0 again
      const T a = x + sag, b = -v / w, above = a * a + b * b - sag * sag;
      T phase = atan2(b, a);
      if (phase < 0) phase += turn;
      const T leaving = above > 0 ? T((turn - atan2(T(sqrt(above)), sag) - phase) / w) : T(left + 1);
      if (left < leaving) {
        const T c = cos(w * left), s = sin(w * left);
        y[0] = a * c - b * s - sag;
        y[1] = -w * (a * s + b * c);
        return;
      }
      left -= leaving, x = 0, v = w * sqrt(above);
    }
  }
  template <class T>
  void invariants(const T* y, T* out) const {
    const T dent = positive_part(T(-y[0]));
    out[0] = T(m) * (y[1] * y[1] / 2 + T(g) * y[0]) + T(k) * dent * dent / 2;
  }
};

}  // namespace odemark
