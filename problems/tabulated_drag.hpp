// A shell whose drag comes from a table with straight lines between its knots, as ballistics programs have
// it.
#pragma once
#include <algorithm>

#include "problems/family.hpp"
#include "problems/piecewise.hpp"

namespace odemark {

/// State (x, v) of a level flight. The drag coefficient rises steeply at the speed of sound; each knot is a
/// kink of the force, and a method of high order is of second order for every step across one.
template <class Real = double>
struct TabulatedDrag {
  static constexpr std::string_view id = "tabulated_drag";
  static constexpr std::string_view title = "Drag from a table with kinks";
  static constexpr std::string_view equations =
      "x' = v;  v' = -k c(v/sound) v |v|,  c(Mach) piecewise linear through (0, 1/4), (3/4, 1/4), (5/4, "
      "3/4), (2, 5/8), (4, 3/8)";
  static constexpr std::string_view source =
      "ours, in the shape of the G1 function (J. M. Ingalls's tables, Artillery Circular M, 1917); a table "
      "read off "
      "by straight lines";
  static constexpr std::size_t size = 2;
  static constexpr std::array<Component, size> components{{{"x", "m"}, {"v", "m/s"}}};
  static constexpr bool force_depends_on_velocity = true;

  Real k = Real(1) / 512, sound = 340, v0 = 850, t_end = 4;

  static constexpr auto parameters() {
    using P = Parameter<TabulatedDrag, Real>;
    return std::array{
        P{"k", "1/m", "drag per mass, speed squared and coefficient", &TabulatedDrag::k, positive},
        P{"sound", "m/s", "speed of sound", &TabulatedDrag::sound, positive},
        P{"v0", "m/s", "initial speed", &TabulatedDrag::v0, positive},
        P{"t_end", "s", "end of the interval", &TabulatedDrag::t_end, positive}};
  }
  static constexpr std::array presets{
      Preset{"tabulated_drag", "", "from Mach 2.5 down through three knots"},
      Preset{"tabulated_drag_subsonic", "v0=240,t_end=2", "between two knots all the time: smooth"}};

  std::array<double, size> scale() const { return {double(v0) * double(t_end), double(v0)}; }
  double suggested_dt() const { return 0.0625 / std::max(4.0, double(k) * double(v0)); }

  template <class T>
  void initial(T* y) const {
    y[0] = T(0), y[1] = T(v0);
  }
  template <class T>
  void acceleration(const T&, const T* y, T* a) const {
    using std::abs;
    const T mach = abs(y[1]) / T(sound);
    // 1/4, then the change of slope at every knot
    const T c = T(1) / T(4) + positive_part(T(mach - T(3) / T(4))) -
                T(7) / T(6) * positive_part(T(mach - T(5) / T(4))) +
                T(1) / T(24) * positive_part(T(mach - T(2)));
    a[0] = -T(k) * c * (y[1] * abs(y[1]));
  }
  template <class T>
  void rhs(const T& t, const T* y, T* dydt) const {
    dydt[0] = y[1];
    acceleration(t, y, &dydt[1]);
  }
};

}  // namespace odemark
