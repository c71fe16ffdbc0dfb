// An elastic beam that is bent by a force at its end: stiff and oscillating, on the imaginary axis.
#pragma once
#include "problems/numbered.hpp"

namespace odemark {

/// The angular accelerations of a beam of n links of total length 1, clamped at one end, under the force
/// (-force, force) at the other: a = C v + D u with C u = D v + (z'^2), where C and D are tridiagonal.
template <std::size_t n, class T>
void beam_acceleration(const T& force, const T* z, const T* speed, T* a) {
  using std::cos, std::sin;
  constexpr int square = int(n * n);
  std::array<T, n> v, w, pivot, next, turned;  // next, turned: -cos and -sin of z_l - z_{l+1}
  for (std::size_t l = 0; l < n; ++l) {
    const T bending = l == 0      ? T(z[1] - 3 * z[0])
                      : l + 1 < n ? T(z[l - 1] - 2 * z[l] + z[l + 1])
                                  : T(z[l - 1] - z[l]);
    v[l] = T(square) * (T(square) * bending + force * (cos(z[l]) + sin(z[l])));
    if (l + 1 < n) next[l] = -cos(z[l] - z[l + 1]), turned[l] = -sin(z[l] - z[l + 1]);
  }
  // D is antisymmetric, C symmetric with the diagonal 1, 2, ..., 2, 3
  const auto by_d = [&](const std::array<T, n>& x, std::size_t l) {
    T sum(0);
    if (l + 1 < n) sum = sum + turned[l] * x[l + 1];
    if (l > 0) sum = sum - turned[l - 1] * x[l - 1];
    return sum;
  };
  const auto diagonal = [](std::size_t l) { return T(l == 0 ? 1 : l + 1 < n ? 2 : 3); };
  for (std::size_t l = 0; l < n; ++l) {
    w[l] = by_d(v, l) + speed[l] * speed[l], pivot[l] = diagonal(l);
    if (l == 0) continue;
    const T factor = next[l - 1] / pivot[l - 1];
    pivot[l] = pivot[l] - factor * next[l - 1], w[l] = w[l] - factor * w[l - 1];
  }
  for (std::size_t l = n; l-- > 0;) w[l] = (l + 1 < n ? T(w[l] - next[l] * w[l + 1]) : w[l]) / pivot[l];
  for (std::size_t l = 0; l < n; ++l) {
    T sum = diagonal(l) * v[l] + by_d(w, l);
    if (l + 1 < n) sum = sum + next[l] * v[l + 1];
    if (l > 0) sum = sum + next[l - 1] * v[l - 1];
    a[l] = sum;
  }
}

/// State: the angles of 8 links against the horizontal, then their velocities. The published force ends at
/// t = pi, and so does this problem.
template <class Real = double>
struct Beam {
  static constexpr std::string_view id = "beam";
  static constexpr std::string_view title = "Elastic beam of eight links";
  static constexpr std::string_view equations =
      "z'' = C v + D u,  C u = D v + (z1'^2, ..., zn'^2),  vl = n^4 (z(l-1) - 2 zl + z(l+1)) + n^2 F (cos zl "
      "+ sin zl), F "
      "= load sin^2 t;  C, D tridiagonal: -cos, -sin of zl - z(l+-1), diagonals (1, 2, ..., 2, 3) and 0; z0 "
      "= -z1, "
      "z(n+1) = zn";
  static constexpr std::string_view source =
      "E. Hairer, G. Wanner, Solving Ordinary Differential Equations II, 2nd ed. (Springer, 1996), IV.1, "
      "doi:10.1007/978-3-642-05221-7; with n = 40: F. Mazzia, C. Magherini, Test Set for Initial Value "
      "Problem "
      "Solvers, release 2.4 (2008), problem beam";
  static constexpr std::size_t links = 8, size = 2 * links;
  static constexpr std::array<Component, size> components =
      joined(numbered<"z", links>("rad"), numbered<"w", links>("rad/s"));
  static constexpr bool force_depends_on_velocity = true;

  Real load = Real(3) / 2, t_end = 3;

  static constexpr auto parameters() {
    using P = Parameter<Beam, Real>;
    return std::array{P{"load", "", "largest force at the free end", &Beam::load, not_negative},
                      P{"t_end", "s", "end of the interval; the force ends at pi", &Beam::t_end,
                        Range{.lowest = 0, .highest = 3.140625, .open_below = true}}};
  }
  static constexpr std::array presets{
      Preset{"beam", "", "the force comes and goes; frequencies up to 250 /s hardly move"},
      Preset{"beam_short", "t_end=0.5", "while the force grows"}};

  std::array<double, size> scale() const {
    std::array<double, size> one;
    one.fill(1);
    return one;
  }
  double suggested_dt() const { return 0x1p-12; }

  template <class T>
  void initial(T* y) const {
    for (std::size_t i = 0; i < size; ++i) y[i] = T(0);
  }
  template <class T>
  void acceleration(const T& t, const T* y, T* a) const {
    using std::sin;
    const T s = sin(t);
    beam_acceleration<links, T>(T(load) * s * s, y, y + links, a);
  }
  template <class T>
  void rhs(const T& t, const T* y, T* dydt) const {
    for (std::size_t i = 0; i < links; ++i) dydt[i] = y[i + links];
    acceleration(t, y, dydt + links);
  }
};

}  // namespace odemark
