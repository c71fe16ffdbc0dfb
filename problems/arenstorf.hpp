// A satellite between earth and moon on a closed orbit with close approaches: why step sizes must adapt.
#pragma once
#include "problems/family.hpp"

namespace odemark {

/// State (x, y, vx, vy) in the frame that turns with earth and moon; the moon, of the share mu of the mass,
/// is at x = 1 - mu, the earth at x = -mu.
template <class Real = double>
struct Arenstorf {
  static constexpr std::string_view id = "arenstorf";
  static constexpr std::string_view title = "Arenstorf orbit";
  static constexpr std::string_view equations =
      "x'' = x + 2 y' - (1-mu)(x+mu)/D1 - mu (x-1+mu)/D2;  y'' = y - 2 x' - (1-mu) y/D1 - mu y/D2,  D1 = "
      "((x+mu)^2 + y^2)^(3/2), D2 = ((x-1+mu)^2 + y^2)^(3/2)";
  static constexpr std::string_view source =
      "R. F. Arenstorf, Amer. J. Math. 85 (1963) 27-35, doi:10.2307/2373181; E. Hairer, S. P. Norsett, G. "
      "Wanner, Solving Ordinary Differential Equations I, 2nd ed. (Springer, 1993), II.0";
  static constexpr std::size_t size = 4;
  static constexpr std::array<Component, size> components{{{"x", ""}, {"y", ""}, {"vx", ""}, {"vy", ""}}};
  static constexpr std::array<std::string_view, 1> invariant_names{"jacobi_energy"};
  static constexpr bool force_depends_on_velocity = true;

  Real mu = Real(12277471) / 1000000000, x0 = Real(994) / 1000,
       vy0 = Real(-200158510637908252LL) / 100000000000000000LL,
       t_end = Real(170652165601579625LL) / 10000000000000000LL;

  static constexpr auto parameters() {
    using P = Parameter<Arenstorf, Real>;
    return std::array{P{"mu", "", "share of the moon in the mass", &Arenstorf::mu,
                        Range{.lowest = 0, .highest = 0.5, .open_below = true}},
                      P{"x0", "", "initial x; y and vx start at 0", &Arenstorf::x0},
                      P{"vy0", "", "initial vy", &Arenstorf::vy0},
                      P{"t_end", "", "end of the interval", &Arenstorf::t_end, positive}};
  }
  static constexpr std::array presets{
      Preset{"arenstorf",
             "mu=0.012277471,x0=0.994,vy0=-2.00158510637908252240537862224,t_end=17."
             "0652165601579625588917206249",
             "one period of the orbit with three loops: the end is the start"},
      Preset{
          "arenstorf_four_loops",
          "mu=0.012277471,x0=0.994,vy0=-2.0317326295573368357302057924,t_end=11.124340337266085134999734047",
          "the shorter orbit with two loops round the earth, closed too"},
      Preset{"arenstorf_first_loop", "mu=0.012277471,x0=0.994,vy0=-2.00158510637908252240537862224,t_end=4",
             "away from the moon and round once: errors have not grown yet"}};

  std::array<double, size> scale() const { return {1, 1, 1, 1}; }
  double suggested_dt() const { return 0x1p-14; }

  template <class T>
  void initial(T* y) const {
    y[0] = T(x0), y[1] = T(0), y[2] = T(0), y[3] = T(vy0);
  }
  template <class T>
  void acceleration(const T&, const T* y, T* a) const {
    using std::sqrt;
    const T rest = 1 - T(mu), e = y[0] + T(mu), m = y[0] - rest, yy = y[1] * y[1];
    const T e2 = e * e + yy, m2 = m * m + yy, earth = rest / (e2 * sqrt(e2)), moon = T(mu) / (m2 * sqrt(m2));
    a[0] = y[0] + 2 * y[3] - earth * e - moon * m;
    a[1] = y[1] - 2 * y[2] - (earth + moon) * y[1];
  }
  template <class T>
  void rhs(const T& t, const T* y, T* dydt) const {
    dydt[0] = y[2], dydt[1] = y[3];
    acceleration(t, y, &dydt[2]);
  }
  template <class T, class J>
  void jacobian(const T&, const T* y, J&& j) const {
    using std::sqrt;
    const T rest = 1 - T(mu), e = y[0] + T(mu), m = y[0] - rest, yy = y[1] * y[1];
    const T e2 = e * e + yy, m2 = m * m + yy, earth = rest / (e2 * sqrt(e2)), moon = T(mu) / (m2 * sqrt(m2));
    const T e3 = 3 * earth / e2, m3 = 3 * moon / m2, cross = (e3 * e + m3 * m) * y[1];
    for (std::size_t row = 0; row < size; ++row)
      for (std::size_t column = 0; column < size; ++column) j(row, column) = T(row + 2 == column ? 1 : 0);
    j(2, 0) = 1 - earth - moon + e3 * e * e + m3 * m * m, j(2, 1) = cross, j(2, 3) = T(2);
    j(3, 0) = cross, j(3, 1) = 1 - earth - moon + (e3 + m3) * yy, j(3, 2) = T(-2);
  }
  /// Kinetic energy in the turning frame and the potential there: minus half of Jacobi's constant.
  template <class T>
  void invariants(const T* y, T* out) const {
    using std::sqrt;
    const T rest = 1 - T(mu), e = y[0] + T(mu), m = y[0] - rest, yy = y[1] * y[1];
    out[0] = (y[2] * y[2] + y[3] * y[3] - y[0] * y[0] - yy) / 2 - rest / sqrt(e * e + yy) -
             T(mu) / sqrt(m * m + yy);
  }
};

}  // namespace odemark
