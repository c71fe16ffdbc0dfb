// The planar two-body problem.
#pragma once
#include <algorithm>

#include "problems/elliptic.hpp"
#include "problems/family.hpp"

namespace odemark {

/// State (x, y, vx, vy) about a fixed centre; starts at the pericentre of an ellipse with semi-major axis 1.
template <class Real = double>
struct Kepler {
  static constexpr std::string_view id = "kepler";
  static constexpr std::string_view title = "Kepler orbit";
  static constexpr std::string_view equations =
      "x' = vx;  y' = vy;  vx' = -mu x/r^3;  vy' = -mu y/r^3,  r = sqrt(x^2 + y^2)";
  static constexpr std::string_view source =
      "D1-D5 of DETEST, T. E. Hull et al., SIAM J. Numer. Anal. 9 (1972) 603-637, doi:10.1137/0709052; "
      "E. Hairer, C. Lubich, G. Wanner, Geometric Numerical Integration, 2nd ed. (Springer, 2006), I.2";
  static constexpr std::size_t size = 4;
  static constexpr std::array<Component, size> components{
      {{"x", "m"}, {"y", "m"}, {"vx", "m/s"}, {"vy", "m/s"}}};
  static constexpr std::array<std::string_view, 4> invariant_names{"energy", "angular_momentum", "laplace_x",
                                                                   "laplace_y"};
  static constexpr bool force_depends_on_velocity = false;

  Real mu = 1, e = Real(3) / 5, t_end = 10;

  static constexpr auto parameters() {
    using P = Parameter<Kepler, Real>;
    return std::array{
        P{"mu", "m^3/s^2", "gravitational parameter", &Kepler::mu, positive},
        P{"e", "", "eccentricity", &Kepler::e, Range{.lowest = 0, .highest = 1, .open_above = true}},
        P{"t_end", "s", "end of the interval", &Kepler::t_end, positive}};
  }
  static constexpr std::array presets{
      Preset{"kepler_e00", "e=0", "a circle"},
      Preset{"kepler_e02", "e=0.2", "a mild ellipse"},
      Preset{"kepler_e05", "e=0.5,t_end=63",
             "ten revolutions: errors of the period add up, for cost against error"},
      Preset{"kepler_e06", "e=0.6", "speeds 4 to 1; the end is no multiple of the period, 2 pi"},
      Preset{"kepler_e09", "e=0.9", "speeds 19 to 1: fixed steps waste most of their work"},
      Preset{"kepler_e099", "e=0.9921875", "speeds 255 to 1, e = 127/128: nearly a fall into the centre"},
      Preset{"kepler_detest_d1", "e=0.1,t_end=20", "DETEST D1"},
      Preset{"kepler_detest_d2", "e=0.3,t_end=20", "DETEST D2"},
      Preset{"kepler_detest_d3", "e=0.5,t_end=20", "DETEST D3"},
      Preset{"kepler_detest_d4", "e=0.7,t_end=20", "DETEST D4"},
      Preset{"kepler_detest_d5", "e=0.9,t_end=20", "DETEST D5: steps over three decades"}};

  std::array<double, size> scale() const {
    const double v = std::sqrt(double(mu));
    return {1, 1, v, v};
  }
  double suggested_dt() const {
    const double nearest = 1 - double(e);
    return 0.05 * nearest * std::sqrt(nearest / double(mu));
  }

  template <class T>
  void initial(T* y) const {
    using std::sqrt;
    y[0] = 1 - T(e), y[1] = T(0);
    y[2] = T(0), y[3] = sqrt(T(mu) * ((1 + T(e)) / (1 - T(e))));
  }
  template <class T>
  void acceleration(const T&, const T* y, T* a) const {
    using std::sqrt;
    const T r2 = y[0] * y[0] + y[1] * y[1], pull = -T(mu) / (r2 * sqrt(r2));
    a[0] = pull * y[0], a[1] = pull * y[1];
  }
  template <class T>
  void rhs(const T& t, const T* y, T* dydt) const {
    dydt[0] = y[2], dydt[1] = y[3];
    acceleration(t, y, &dydt[2]);
  }
  template <class T, class J>
  void jacobian(const T&, const T* y, J&& j) const {
    using std::sqrt;
    const T r2 = y[0] * y[0] + y[1] * y[1], pull = -T(mu) / (r2 * sqrt(r2)), tide = -3 * pull / r2;
    for (std::size_t row = 0; row < 2; ++row)
      for (std::size_t column = 0; column < 2; ++column) {
        j(row, column) = T(0), j(row, column + 2) = row == column ? T(1) : T(0);
        j(row + 2, column) = tide * y[row] * y[column] + (row == column ? pull : T(0));
        j(row + 2, column + 2) = T(0);
      }
  }

  /// The exact flow of any bound state y0 at t = 0, apsis or not: Gauss's f and g functions of the eccentric
  /// anomaly gained since, E; ec and es are e cos and e sin of the anomaly at the start.
  template <class T>
  void exact(const T& t, const T* y0, T* y) const {
    using std::cos, std::sin, std::sqrt;
    const T r0 = sqrt(y0[0] * y0[0] + y0[1] * y0[1]), v2 = y0[2] * y0[2] + y0[3] * y0[3];
    const T ec = r0 * v2 / T(mu) - 1, a = r0 / (1 - ec), n = sqrt(T(mu) / a) / a;
    const T es = (y0[0] * y0[2] + y0[1] * y0[3]) / (n * a * a);
    const T turn = 2 * elliptic::pi<T>(), mean = n * t - turn * elliptic::nearest(T(n * t / turn));
    const T E = anomaly(mean, ec, es), half = sin(E / 2), si = sin(E), versine = 2 * half * half;
    const T r = a * (1 - ec * cos(E) + es * si);
    const T f = 1 - a / r0 * versine, g = (r0 / a * si + es * versine) / n;
    const T df = -n * a * a / (r * r0) * si, dg = 1 - a / r * versine;
    const T start[size] = {y0[0], y0[1], y0[2], y0[3]};
    for (std::size_t i = 0; i < 2; ++i) {
      y[i] = f * start[i] + g * start[i + 2];
      y[i + 2] = df * start[i] + dg * start[i + 2];
    }
  }
  /// Per mass; the Laplace vector points to the pericentre and has the length mu e.
  template <class T>
  void invariants(const T* y, T* out) const {
    using std::sqrt;
    const T r = sqrt(y[0] * y[0] + y[1] * y[1]), h = y[0] * y[3] - y[1] * y[2];
    out[0] = (y[2] * y[2] + y[3] * y[3]) / 2 - T(mu) / r;
    out[1] = h;
    out[2] = y[3] * h - T(mu) * y[0] / r;
    out[3] = -y[2] * h - T(mu) * y[1] / r;
  }

 private:
  /// Kepler's equation E - ec sin E + es (1 - cos E) = mean by Newton steps inside a shrinking bracket.
  template <class T>
  static T anomaly(const T& mean, const T& ec, const T& es) {
    using std::abs, std::cos, std::sin;
    T low = mean - 2, high = mean + 2, E = mean;
    for (int i = 0; i < 500; ++i) {
      const T miss = E - ec * sin(E) + es * (1 - cos(E)) - mean;
      (miss < 0 ? low : high) = E;
      T next = E - miss / (1 - ec * cos(E) + es * sin(E));
      if (!(low <= next && next <= high)) next = (low + high) / 2;
      const T step = abs(next - E);
      E = next;
      if (step <= std::numeric_limits<T>::epsilon() * std::max(T(1), T(abs(E)))) break;
    }
    return E;
  }
};

}  // namespace odemark
