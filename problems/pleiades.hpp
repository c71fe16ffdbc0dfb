// Seven stars in a plane: the classic smooth problem whose right-hand side costs more than a step's
// bookkeeping.
#pragma once
#include "problems/family.hpp"

namespace odemark {

/// State (x1..x7, y1..y7, x1'..x7', y1'..y7'), star i of mass i, gravitational constant 1. Two pairs come
/// as close as 0.11 and 0.14, at t = 1.23 and 1.68.
template <class Real = double>
struct Pleiades {
  static constexpr std::string_view id = "pleiades";
  static constexpr std::string_view title = "Pleiades, seven bodies in a plane";
  static constexpr std::string_view equations =
      "xi'' = sum over j of mj (xj - xi)/rij^3;  yi'' likewise;  rij = sqrt((xi - xj)^2 + (yi - yj)^2),  mj "
      "= "
      "j";
  static constexpr std::string_view source =
      "E. Hairer, S. P. Norsett, G. Wanner, Solving Ordinary Differential Equations I, 2nd ed. (Springer, "
      "1993), II.10; F. Mazzia, C. Magherini, Test Set for Initial Value Problem Solvers, release 2.4 "
      "(2008), "
      "problem plei";
  static constexpr std::size_t stars = 7, size = 4 * stars;
  static constexpr std::array<Component, size> components{
      {{"x1", ""},  {"x2", ""},  {"x3", ""},  {"x4", ""},  {"x5", ""},  {"x6", ""},  {"x7", ""},
       {"y1", ""},  {"y2", ""},  {"y3", ""},  {"y4", ""},  {"y5", ""},  {"y6", ""},  {"y7", ""},
       {"vx1", ""}, {"vx2", ""}, {"vx3", ""}, {"vx4", ""}, {"vx5", ""}, {"vx6", ""}, {"vx7", ""},
       {"vy1", ""}, {"vy2", ""}, {"vy3", ""}, {"vy4", ""}, {"vy5", ""}, {"vy6", ""}, {"vy7", ""}}};
  static constexpr std::array<std::string_view, 4> invariant_names{"energy", "momentum_x", "momentum_y",
                                                                   "angular_momentum"};
  static constexpr bool force_depends_on_velocity = false;

  Real mass = 1, t_end = 3;

  static constexpr auto parameters() {
    using P = Parameter<Pleiades, Real>;
    return std::array{
        P{"mass", "", "mass of the lightest star; star i has i times that", &Pleiades::mass, positive},
        P{"t_end", "", "end of the interval", &Pleiades::t_end, positive}};
  }
  static constexpr std::array presets{
      Preset{"pleiades", "", "three units of time with two close encounters"}};

  std::array<double, size> scale() const {
    std::array<double, size> natural{};
    for (std::size_t i = 0; i < size; ++i) natural[i] = i < size / 2 ? 4 : 4 * std::sqrt(double(mass));
    return natural;
  }
  double suggested_dt() const { return 0x1p-13 / std::sqrt(double(mass)); }

  template <class T>
  void initial(T* y) const {
    constexpr std::array<double, size> start{3, 3, -1, -3, 2, -2, 2, 3, -3, 2, 0, 0, -4, 4,
                                             0, 0, 0,  0,  0, 0,  0, 0, 0,  0, 0, 0, 0,  0};
    for (std::size_t i = 0; i < size; ++i) y[i] = T(start[i]);
    y[19] = T(7) / T(4), y[20] = T(-3) / T(2);  // vx6, vx7
    y[24] = T(-5) / T(4), y[25] = T(1);         // vy4, vy5
  }
  template <class T>
  void acceleration(const T&, const T* y, T* a) const {
    using std::sqrt;
    const T *x = y, *z = y + stars;
    for (std::size_t i = 0; i < 2 * stars; ++i) a[i] = T(0);
    for (std::size_t i = 1; i < stars; ++i)
      for (std::size_t j = 0; j < i; ++j) {
        const T dx = x[j] - x[i], dz = z[j] - z[i], r2 = dx * dx + dz * dz, pull = T(mass) / (r2 * sqrt(r2));
        const T here = T(double(j + 1)) * pull, there = T(double(i + 1)) * pull;
        a[i] = a[i] + here * dx, a[i + stars] = a[i + stars] + here * dz;
        a[j] = a[j] - there * dx, a[j + stars] = a[j + stars] - there * dz;
      }
  }
  template <class T>
  void rhs(const T& t, const T* y, T* dydt) const {
    for (std::size_t i = 0; i < 2 * stars; ++i) dydt[i] = y[i + 2 * stars];
    acceleration(t, y, dydt + 2 * stars);
  }
  template <class T, class J>
  void jacobian(const T&, const T* y, J&& j) const {
    using std::sqrt;
    constexpr std::size_t half = size / 2;
    for (std::size_t column = 0; column < size; ++column)
      for (std::size_t row = 0; row < size; ++row) j(row, column) = row + half == column ? T(1) : T(0);
    for (std::size_t i = 0; i < stars; ++i)
      for (std::size_t k = 0; k < stars; ++k) {
        if (k == i) continue;
        const T dx = y[k] - y[i], dz = y[k + stars] - y[i + stars], r2 = dx * dx + dz * dz;
        const T pull = T(mass) * T(double(k + 1)) / (r2 * sqrt(r2)), tide = 3 * pull / r2;
        const T xx = pull - tide * dx * dx, xz = -(tide * dx * dz), zz = pull - tide * dz * dz;
        const std::size_t x = half + i, z = x + stars;
        j(x, k) = xx, j(x, k + stars) = xz, j(z, k) = xz, j(z, k + stars) = zz;
        j(x, i) = j(x, i) - xx, j(x, i + stars) = j(x, i + stars) - xz;
        j(z, i) = j(z, i) - xz, j(z, i + stars) = j(z, i + stars) - zz;
      }
  }
  template <class T>
  void invariants(const T* y, T* out) const {
    using std::sqrt;
    const T *x = y, *z = y + stars, *u = z + stars, *w = u + stars;
    for (std::size_t i = 0; i < invariant_names.size(); ++i) out[i] = T(0);
    for (std::size_t i = 0; i < stars; ++i) {
      const T m = T(mass) * T(double(i + 1));
      out[0] = out[0] + m * (u[i] * u[i] + w[i] * w[i]) / 2;
      out[1] = out[1] + m * u[i], out[2] = out[2] + m * w[i];
      out[3] = out[3] + m * (x[i] * w[i] - z[i] * u[i]);
      for (std::size_t j = 0; j < i; ++j) {
        const T dx = x[j] - x[i], dz = z[j] - z[i];
        out[0] = out[0] - m * T(mass) * T(double(j + 1)) / sqrt(dx * dx + dz * dz);
      }
    }
  }
};

}  // namespace odemark
