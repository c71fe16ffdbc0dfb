// The plane pendulum: swinging, turning over, and crawling beside the separatrix between the two.
#pragma once
#include "problems/elliptic.hpp"
#include "problems/family.hpp"

namespace odemark {

/// State (theta, omega); theta = 0 hangs down. The angle is not reduced: it counts the turns.
template <class Real = double>
struct Pendulum {
  static constexpr std::string_view id = "pendulum";
  static constexpr std::string_view title = "Plane pendulum";
  static constexpr std::string_view equations = "theta' = omega;  omega' = -(g/length) sin(theta)";
  static constexpr std::string_view source =
      "D. F. Lawden, Elliptic Functions and Applications (Springer, 1989), 5.1, "
      "doi:10.1007/978-1-4757-3980-0";
  static constexpr std::size_t size = 2;
  static constexpr std::array<Component, size> components{{{"theta", "rad"}, {"omega", "rad/s"}}};
  static constexpr std::array<std::string_view, 1> invariant_names{"energy"};
  static constexpr bool force_depends_on_velocity = false;

  Real g = Real(157) / 16, length = 1, theta0 = Real(201) / 128, omega0 = 0, t_end = 10;

  static constexpr auto parameters() {
    using P = Parameter<Pendulum, Real>;
    return std::array{P{"g", "m/s^2", "gravity", &Pendulum::g, positive},
                      P{"length", "m", "length of the rod", &Pendulum::length, positive},
                      P{"theta0", "rad", "initial angle from hanging down", &Pendulum::theta0},
                      P{"omega0", "rad/s", "initial angular velocity", &Pendulum::omega0},
                      P{"t_end", "s", "end of the interval", &Pendulum::t_end, positive}};
  }
  static constexpr std::array presets{
      Preset{"pendulum", "", "released at 90 degrees (to a dyadic number, as below)"},
      Preset{"pendulum_170", "theta0=2.96875,t_end=10.5", "released at 170 degrees"},
      Preset{"pendulum_near_separatrix", "theta0=3.139892578125,t_end=20", "released at 179.9 degrees"},
      Preset{"pendulum_rotating", "theta0=0,omega0=7", "fast enough to turn over and over"},
      Preset{"pendulum_just_over", "theta0=0,omega0=6.265625",
             "the separatrix is at 6.265: it creeps over the top again and again"}};

  std::array<double, size> scale() const { return {1, std::sqrt(double(g) / double(length))}; }
  double suggested_dt() const { return 0.05 / std::sqrt(double(g) / double(length)); }

  template <class T>
  void initial(T* y) const {
    y[0] = T(theta0), y[1] = T(omega0);
  }
  template <class T>
  void acceleration(const T&, const T* y, T* a) const {
    using std::sin;
    a[0] = -(T(g) / T(length)) * sin(y[0]);
  }
  template <class T>
  void rhs(const T& t, const T* y, T* dydt) const {
    dydt[0] = y[1];
    acceleration(t, y, &dydt[1]);
  }
  template <class T, class J>
  void jacobian(const T&, const T* y, J&& j) const {
    using std::cos;
    j(0, 0) = T(0), j(0, 1) = T(1);
    j(1, 0) = -(T(g) / T(length)) * cos(y[0]), j(1, 1) = T(0);
  }

  /// The exact flow: y0 is the state at t = 0. With w = sqrt(g/length), sin(theta/2) is k sn(w t + phase)
  /// while swinging and sn(k w t + phase) while turning, of modulus k and 1/k. The phase enters by the
  /// addition theorems, through S = sin, D = cos of theta0/2 and P = omega0/(2 w) alone; k^2 = S^2 + P^2 and
  /// 1 - k^2 = D^2 - P^2.
  template <class T>
  void exact(const T& t, const T* y0, T* y) const {
    using std::abs, std::atan2, std::cos, std::sin, std::sqrt;
    const T w = sqrt(T(g) / T(length)), turn = 2 * elliptic::pi<T>();
    const T turns = elliptic::nearest(T(y0[0] / turn)), theta = y0[0] - turns * turn;
    const T S = sin(theta / 2), D = cos(theta / 2), P = y0[1] / (2 * w);
    const T room = (abs(D) - abs(P)) * (abs(D) + abs(P));
    if (room >= 0) {
      const auto [s, c, d] = elliptic::jacobi(T(w * t), T(sqrt(room)));
      const T below = c * c + s * s * D * D;
      y[0] = turns * turn + 2 * atan2(T((S * c * d + s * P * D) / below), T((D * d - S * P * s * c) / below));
      y[1] = 2 * w * (P * c - S * D * s * d) / below;
    } else {
      const T k = (P < 0 ? -1 : 1) * sqrt(S * S + P * P), kc = sqrt(-room) / abs(k), fast = P / k;
      const T u = k * w * t, half = elliptic::quarter_period(kc) * 2, over = elliptic::nearest(T(u / half));
      const auto [s, c, d] = elliptic::jacobi(T(u - (over == 0 ? T(0) : T(over * half))), kc);
      const T below = c * c + s * s * fast * fast;
      const T S1 = (S * c * d + s * D * fast) / below, D1 = (D * c - S * fast * s * d) / below;
      y[0] = y0[0] + turn * over + 2 * atan2(T(S1 * D - D1 * S), T(D1 * D + S1 * S));
      y[1] = 2 * w * k * (fast * d - S * D / (k * k) * s * c) / below;
    }
  }
  /// Per mass.
  template <class T>
  void invariants(const T* y, T* out) const {
    using std::sin;
    const T speed = T(length) * y[1], s = sin(y[0] / 2);
    out[0] = speed * speed / 2 + 2 * T(g) * T(length) * s * s;
  }
};

}  // namespace odemark
