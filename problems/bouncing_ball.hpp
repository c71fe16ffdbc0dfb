// A ball that bounces: a jump in the state, found by the state itself, again and again.
#pragma once
#include "problems/family.hpp"

namespace odemark {

/// State (x, v), height and speed upwards. At the floor v turns into -e v. A ball that would leave it slower
/// than v_rest stays: otherwise it bounces infinitely often before the time v0/g (1 + e)/(1 - e) after a
/// bounce with v0 (Zeno's ball).
template <class Real = double>
struct BouncingBall {
  static constexpr std::string_view id = "bouncing_ball";
  static constexpr std::string_view title = "Bouncing ball";
  static constexpr std::string_view equations = "x' = v;  v' = -g;  v -> -e v where x = 0";
  static constexpr std::string_view source =
      "A. J. van der Schaft, J. M. Schumacher, An Introduction to Hybrid Dynamical Systems (Springer, 2000), "
      "2.2.3, "
      "doi:10.1007/BFb0109998; OTP test problems, bouncing ball; v_rest is ours";
  static constexpr std::size_t size = 2;
  static constexpr std::array<Component, size> components{{{"x", "m"}, {"v", "m/s"}}};
  static constexpr std::array<std::string_view, 1> events{"bounce"};
  static constexpr std::size_t phase_count = 2;  // flying, at rest
  static constexpr bool force_depends_on_velocity = false;

  Real g = Real(628) / 64, e = Real(7) / 8, x0 = 1, v0 = 0, v_rest = Real(1) / 64, t_end = 2;
  bool rests = false;

  static constexpr auto parameters() {
    using P = Parameter<BouncingBall, Real>;
    return std::array{
        P{"g", "m/s^2", "gravity", &BouncingBall::g, positive},
        P{"e", "", "restitution: speed after a bounce over speed before", &BouncingBall::e,
          Range{.lowest = 0, .highest = 1}},
        P{"x0", "m", "initial height", &BouncingBall::x0, positive},
        P{"v0", "m/s", "initial speed upwards", &BouncingBall::v0},
        P{"v_rest", "m/s", "a slower ball does not leave the floor", &BouncingBall::v_rest, positive},
        P{"t_end", "s", "end of the interval", &BouncingBall::t_end, positive}};
  }
  static constexpr std::array presets{
      Preset{"bouncing_ball", "", "three bounces with e = 7/8"},
      Preset{"bouncing_ball_elastic", "e=1,t_end=10",
             "ten bounces, no loss: the height says what bounces cost"},
      Preset{"bouncing_ball_zeno", "e=0.5,t_end=2", "nine bounces, ever faster, then rest before the end"}};

  std::array<double, size> scale() const {
    const double top = double(x0) + double(v0) * double(v0) / (2 * double(g));
    return {top, std::sqrt(2 * double(g) * top)};
  }
  double suggested_dt() const { return 1.0 / 64; }
  BouncingBall during(std::size_t phase) const {
    BouncingBall held = *this;
    held.rests = phase == 1;
    return held;
  }

  template <class T>
  void initial(T* y) const {
    y[0] = T(x0), y[1] = T(v0);
  }
  template <class T>
  void acceleration(const T&, const T*, T* a) const {
    a[0] = rests ? T(0) : T(-g);
  }
  template <class T>
  void rhs(const T& t, const T* y, T* dydt) const {
    dydt[0] = rests ? T(0) : y[1];
    acceleration(t, y, &dydt[1]);
  }
  template <class T>
  void event_values(const T&, const T* y, T* g_out) const {
    g_out[0] = rests ? T(1) : y[0];
  }
  template <class T>
  std::size_t after_event(std::size_t, const T&, T* y) const {
    y[0] = T(0);
    if (y[1] < 0) y[1] = -T(e) * y[1];
    if (!(y[1] < T(v_rest))) return 0;
    y[1] = T(0);
    return 1;
  }

  /// The exact flow: y0, above the floor, is the state at t = 0.
  template <class T>
  void exact(const T& t, const T* y0, T* y) const {
    exact(t, y0, y, [](std::size_t, const T&) {});
  }
  template <class T, class Visit>
  void exact(const T& t, const T* y0, T* y, Visit&& visit) const {
    using std::sqrt;
    T x = y0[0], v = y0[1], begun = 0;
    for (;;) {
      const T landing = (v + sqrt(v * v + 2 * T(g) * x)) / T(g), left = t - begun;
      if (left < landing) {
        y[0] = x + left * (v - T(g) * left / 2), y[1] = v - T(g) * left;
        return;
      }
      begun += landing;
      visit(0, begun);
      x = T(0), v = T(e) * (T(g) * landing - v);
      if (v < T(v_rest)) break;
    }
    y[0] = y[1] = T(0);
  }
};

}  // namespace odemark
