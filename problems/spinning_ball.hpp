// A ball with spin in the air: drag and the Magnus force, in three dimensions.
#pragma once
#include <algorithm>

#include "problems/family.hpp"

namespace odemark {

/// State (x, y, z, vx, vy, vz); the spin keeps its axis and its rate.
template <class Real = double>
struct SpinningBall {
  static constexpr std::string_view id = "spinning_ball";
  static constexpr std::string_view title = "Spinning ball with drag and Magnus force";
  static constexpr std::string_view equations = "x' = v;  v' = -k |v| v + s (w x v) - g e_z";
  static constexpr std::string_view source =
      "A. M. Nathan, Am. J. Phys. 76 (2008) 119-124, doi:10.1119/1.2805242; lift proportional to the spin, "
      "as of a "
      "ball of small spin parameter";
  static constexpr std::size_t size = 6;
  static constexpr std::array<Component, size> components{
      {{"x", "m"}, {"y", "m"}, {"z", "m"}, {"vx", "m/s"}, {"vy", "m/s"}, {"vz", "m/s"}}};
  static constexpr bool force_depends_on_velocity = true;

  Real k = Real(3) / 512, s = Real(1) / 2048, w1 = 0, w2 = -150, w3 = 100, g = Real(157) / 16;
  Real vx0 = 40, vy0 = 0, vz0 = 10, t_end = 4;

  static constexpr auto parameters() {
    using P = Parameter<SpinningBall, Real>;
    return std::array{P{"k", "1/m", "drag per mass and speed squared", &SpinningBall::k, positive},
                      P{"s", "", "Magnus acceleration per spin and speed", &SpinningBall::s},
                      P{"w1", "rad/s", "spin about x: to roll", &SpinningBall::w1},
                      P{"w2", "rad/s", "spin about y: negative is backspin", &SpinningBall::w2},
                      P{"w3", "rad/s", "spin about z: positive curves to the left", &SpinningBall::w3},
                      P{"g", "m/s^2", "gravity", &SpinningBall::g, not_negative},
                      P{"vx0", "m/s", "initial speed ahead", &SpinningBall::vx0, positive},
                      P{"vy0", "m/s", "initial speed to the left", &SpinningBall::vy0},
                      P{"vz0", "m/s", "initial speed upwards", &SpinningBall::vz0},
                      P{"t_end", "s", "end of the interval", &SpinningBall::t_end, positive}};
  }
  static constexpr std::array presets{
      Preset{"spinning_ball", "", "a fly ball with backspin and sidespin: lifted and bent to the left"},
      Preset{"spinning_ball_floating", "k=1/64,s=1/64,w2=-256,w3=64,vx0=20,vz0=0,t_end=8",
             "a beach ball: the lift of the backspin makes it loop"}};

  std::array<double, size> scale() const {
    const double v = std::hypot(double(vx0), double(vy0), double(vz0)), way = v * double(t_end);
    return {way, way, way, v, v, v};
  }
  double suggested_dt() const {
    const double turn = std::abs(double(s)) * std::hypot(double(w1), double(w2), double(w3));
    return 0.0625 / std::max({2.0, turn, double(k) * std::hypot(double(vx0), double(vy0), double(vz0))});
  }

  template <class T>
  void initial(T* y) const {
    y[0] = T(0), y[1] = T(0), y[2] = T(0);
    y[3] = T(vx0), y[4] = T(vy0), y[5] = T(vz0);
  }
  template <class T>
  void acceleration(const T&, const T* y, T* a) const {
    using std::sqrt;
    const T &vx = y[3], &vy = y[4], &vz = y[5];
    const T drag = -T(k) * sqrt(vx * vx + vy * vy + vz * vz), x = T(s) * T(w1), yy = T(s) * T(w2),
            z = T(s) * T(w3);
    a[0] = drag * vx + yy * vz - z * vy;
    a[1] = drag * vy + z * vx - x * vz;
    a[2] = drag * vz + x * vy - yy * vx - T(g);
  }
  template <class T>
  void rhs(const T& t, const T* y, T* dydt) const {
    dydt[0] = y[3], dydt[1] = y[4], dydt[2] = y[5];
    acceleration(t, y, &dydt[3]);
  }
};

}  // namespace odemark
