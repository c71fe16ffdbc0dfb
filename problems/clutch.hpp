// Two shafts and a slipping clutch: the difference of speeds is stiff, the total momentum is not.
#pragma once
#include <algorithm>

#include "problems/family.hpp"

namespace odemark {

/// State (w1, w2): angular velocities of the two shafts. The difference decays at c (1/J1 + 1/J2).
template <class Real = double>
struct Clutch {
  static constexpr std::string_view id = "clutch";
  static constexpr std::string_view title = "Two shafts and a viscous clutch";
  static constexpr std::string_view equations = "J1 w1' = -c (w1 - w2);  J2 w2' = c (w1 - w2)";
  static constexpr std::string_view source = "ours: Newton's law for two flywheels and a linear damper";
  static constexpr std::size_t size = 2;
  static constexpr std::array<Component, size> components{{{"w1", "rad/s"}, {"w2", "rad/s"}}};
  static constexpr std::array<std::string_view, 1> invariant_names{"momentum"};

  Real J1 = Real(1) / 8, J2 = Real(3) / 4, c = 1, w1 = 100, w2 = 20, t_end = 1;

  static constexpr auto parameters() {
    using P = Parameter<Clutch, Real>;
    return std::array{P{"J1", "kg m^2", "inertia of the first shaft", &Clutch::J1, positive},
                      P{"J2", "kg m^2", "inertia of the second shaft", &Clutch::J2, positive},
                      P{"c", "N m s", "damping of the clutch", &Clutch::c, positive},
                      P{"w1", "rad/s", "initial speed of the first shaft", &Clutch::w1},
                      P{"w2", "rad/s", "initial speed of the second shaft", &Clutch::w2},
                      P{"t_end", "s", "end of the interval", &Clutch::t_end, positive}};
  }
  static constexpr std::array presets{
      Preset{"clutch", "", "slips for a tenth of a second"},
      Preset{"clutch_stiff", "c=50",
             "467 per second: explicit Euler at 60 Hz explodes, with the total momentum still exact"}};

  std::array<double, size> scale() const {
    const double w = std::max({std::abs(double(w1)), std::abs(double(w2)), 1e-3});
    return {w, w};
  }
  double suggested_dt() const { return 0.25 / (double(c) * (1 / double(J1) + 1 / double(J2))); }

  template <class T>
  void initial(T* y) const {
    y[0] = T(w1), y[1] = T(w2);
  }
  template <class T>
  void rhs(const T&, const T* y, T* dydt) const {
    const T torque = T(c) * (y[0] - y[1]);
    dydt[0] = -torque / T(J1);
    dydt[1] = torque / T(J2);
  }
  template <class T, class J>
  void jacobian(const T&, const T*, J&& j) const {
    linear_part<T>(j);
  }
  template <class T, class L>
  void linear_part(L&& l) const {
    l(0, 0) = -T(c) / T(J1), l(0, 1) = T(c) / T(J1);
    l(1, 0) = T(c) / T(J2), l(1, 1) = -T(c) / T(J2);
  }
  /// The same system with every drive removed: 0 is its fixed point.
  Clutch homogeneous() const { return *this; }

  /// The exact flow: y0 is the state at t = 0.
  template <class T>
  void exact(const T& t, const T* y0, T* y) const {
    using std::expm1;
    const T total = T(J1) + T(J2), rate = T(c) * total / (T(J1) * T(J2));
    const T lost = (y0[0] - y0[1]) * expm1(-rate * t), first = y0[0], second = y0[1];
    y[0] = first + lost * T(J2) / total;
    y[1] = second - lost * T(J1) / total;
  }
  template <class T>
  void invariants(const T* y, T* out) const {
    out[0] = T(J1) * y[0] + T(J2) * y[1];
  }
};

}  // namespace odemark
