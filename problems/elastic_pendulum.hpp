// A weight on a spring that swings: what becomes of a rod that is replaced by a stiff spring.
#pragma once
#include <algorithm>

#include "problems/family.hpp"

namespace odemark {

/// State (x, y, vx, vy) about the pivot, y upwards. Starts at rest, the spring at its own length.
template <class Real = double>
struct ElasticPendulum {
  static constexpr std::string_view id = "elastic_pendulum";
  static constexpr std::string_view title = "Pendulum on a spring";
  static constexpr std::string_view equations = "m r'' = -k (|r| - L) r/|r| - m g e_y";
  static constexpr std::string_view source =
      "A. Vitt, G. Gorelik, Zh. Tekh. Fiz. 3 (1933) 294-307; P. Lynch, Int. J. Non-Linear Mech. 37 (2002) "
      "345-367, "
      "doi:10.1016/S0020-7462(00)00121-9";
  static constexpr std::size_t size = 4;
  static constexpr std::array<Component, size> components{
      {{"x", "m"}, {"y", "m"}, {"vx", "m/s"}, {"vy", "m/s"}}};
  static constexpr std::array<std::string_view, 1> invariant_names{"energy"};
  static constexpr bool force_depends_on_velocity = false;

  Real k = 64, m = 1, L = 1, g = Real(157) / 16, slope = 1, t_end = 10;

  static constexpr auto parameters() {
    using P = Parameter<ElasticPendulum, Real>;
    return std::array{P{"k", "N/m", "stiffness of the spring", &ElasticPendulum::k, positive},
                      P{"m", "kg", "mass", &ElasticPendulum::m, positive},
                      P{"L", "m", "length of the spring at rest", &ElasticPendulum::L, positive},
                      P{"g", "m/s^2", "gravity", &ElasticPendulum::g, not_negative},
                      P{"slope", "", "tangent of the initial angle from hanging", &ElasticPendulum::slope},
                      P{"t_end", "s", "end of the interval", &ElasticPendulum::t_end, positive}};
  }
  static constexpr std::array presets{
      Preset{"elastic_pendulum", "", "soft: swing and bounce exchange their energy"},
      Preset{"elastic_pendulum_stiff", "k=16384,t_end=1", "128 rad/s on a swing of 3: the spring hums"},
      Preset{"elastic_pendulum_rod", "k=1048576,t_end=1/8", "1024 rad/s: a rod by penalty"}};

  std::array<double, size> scale() const {
    const double v = std::sqrt(double(L) * std::max(double(g), 1e-3));
    return {double(L), double(L), v, v};
  }
  double suggested_dt() const { return 0.0625 * std::sqrt(double(m) / double(k)); }

  template <class T>
  void initial(T* y) const {
    using std::sqrt;
    const T down = T(L) / sqrt(1 + T(slope) * T(slope));
    y[0] = down * T(slope), y[1] = -down, y[2] = T(0), y[3] = T(0);
  }
  template <class T>
  void acceleration(const T&, const T* y, T* a) const {
    using std::sqrt;
    const T r = sqrt(y[0] * y[0] + y[1] * y[1]), pull = T(k) / T(m) * (T(L) / r - 1);
    a[0] = pull * y[0];
    a[1] = pull * y[1] - T(g);
  }
  template <class T>
  void rhs(const T& t, const T* y, T* dydt) const {
    dydt[0] = y[2], dydt[1] = y[3];
    acceleration(t, y, &dydt[2]);
  }
  template <class T, class J>
  void jacobian(const T&, const T* y, J&& j) const {
    using std::sqrt;
    const T r2 = y[0] * y[0] + y[1] * y[1], r = sqrt(r2), rate = T(k) / T(m);
    for (std::size_t row = 0; row < 2; ++row)
      for (std::size_t column = 0; column < 2; ++column) {
        const T unit = row == column ? T(1) : T(0);
        j(row, column) = T(0), j(row, column + 2) = unit;
        j(row + 2, column) = rate * ((T(L) / r - 1) * unit - T(L) / (r2 * r) * y[row] * y[column]);
        j(row + 2, column + 2) = T(0);
      }
  }
  template <class T>
  void invariants(const T* y, T* out) const {
    using std::sqrt;
    const T stretch = sqrt(y[0] * y[0] + y[1] * y[1]) - T(L);
    out[0] = T(m) * ((y[2] * y[2] + y[3] * y[3]) / 2 + T(g) * y[1]) + T(k) * stretch * stretch / 2;
  }
};

}  // namespace odemark
