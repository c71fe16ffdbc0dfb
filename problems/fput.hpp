// A chain of masses with springs a little beyond Hooke's law: the first numerical experiment on heat.
#pragma once
#include "problems/elliptic.hpp"
#include "problems/numbered.hpp"

namespace odemark {

/// State: displacements of 8 masses between fixed ends, then velocities; starts in the lowest mode.
template <class Real = double>
struct Fput {
  static constexpr std::string_view id = "fput";
  static constexpr std::string_view title = "Fermi-Pasta-Ulam-Tsingou chain";
  static constexpr std::string_view equations =
      "xi'' = F(x(i+1) - xi) - F(xi - x(i-1)),  F(r) = r + alpha r^2 + beta r^3;  xi(0) = amplitude sin(i "
      "pi/9)";
  static constexpr std::string_view source =
      "E. Fermi, J. Pasta, S. Ulam, Los Alamos report LA-1940 (1955), with M. Tsingou, doi:10.2172/4376203";
  static constexpr std::size_t masses = 8, size = 2 * masses;
  static constexpr std::array<Component, size> components =
      joined(numbered<"x", masses>(""), numbered<"v", masses>(""));
  static constexpr std::array<std::string_view, 1> invariant_names{"energy"};
  static constexpr bool force_depends_on_velocity = false;

  Real alpha = Real(1) / 4, beta = 0, amplitude = 1, t_end = 100;

  static constexpr auto parameters() {
    using P = Parameter<Fput, Real>;
    return std::array{P{"alpha", "", "quadratic part of the force", &Fput::alpha, not_negative},
                      P{"beta", "", "cubic part of the force", &Fput::beta, not_negative},
                      P{"amplitude", "", "of the lowest mode at the start", &Fput::amplitude, positive},
                      P{"t_end", "", "end of the interval", &Fput::t_end, positive}};
  }
  static constexpr std::array presets{
      Preset{"fput", "", "alpha = 1/4: energy goes to the higher modes and comes back"},
      Preset{"fput_beta", "alpha=0,beta=2,t_end=50", "the cubic chain, strongly excited"}};

  std::array<double, size> scale() const {
    std::array<double, size> out{};
    for (std::size_t i = 0; i < size; ++i) out[i] = double(amplitude) * (i < masses ? 1 : 0.5);
    return out;
  }
  double suggested_dt() const { return 0.0625; }

  template <class T>
  void initial(T* y) const {
    using std::sin;
    for (std::size_t i = 0; i < masses; ++i) {
      y[i] = T(amplitude) * sin(elliptic::pi<T>() * int(i + 1) / int(masses + 1));
      y[i + masses] = T(0);
    }
  }
  template <class T>
  void acceleration(const T&, const T* y, T* a) const {
    T left = force<T>(y[0]);
    for (std::size_t i = 0; i < masses; ++i) {
      const T right = force<T>(i + 1 < masses ? T(y[i + 1] - y[i]) : T(-y[i]));
      a[i] = right - left;
      left = right;
    }
  }
  template <class T>
  void rhs(const T& t, const T* y, T* dydt) const {
    for (std::size_t i = 0; i < masses; ++i) dydt[i] = y[i + masses];
    acceleration(t, y, dydt + masses);
  }
  template <class T, class J>
  void jacobian(const T&, const T* y, J&& j) const {
    chain<T>(j, [&](std::size_t i) {
      const T r = stretch(y, i);
      return T(1 + (2 * T(alpha) + 3 * T(beta) * r) * r);
    });
  }
  template <class T, class L>
  void linear_part(L&& l) const {
    chain<T>(l, [](std::size_t) { return T(1); });
  }
  template <class T>
  void invariants(const T* y, T* out) const {
    out[0] = T(0);
    for (std::size_t i = 0; i < masses; ++i) out[0] = out[0] + y[i + masses] * y[i + masses] / 2;
    for (std::size_t i = 0; i <= masses; ++i) {
      const T r = stretch(y, i);
      out[0] = out[0] + r * r * (T(1) / 2 + r * (T(alpha) / 3 + r * T(beta) / 4));
    }
  }

 private:
  template <class T>
  T force(const T& r) const {
    return r + (T(alpha) + T(beta) * r) * (r * r);
  }
  /// Of spring i, between masses i - 1 and i.
  template <class T>
  static T stretch(const T* y, std::size_t i) {
    return i == 0 ? y[0] : i < masses ? T(y[i] - y[i - 1]) : T(-y[masses - 1]);
  }
  /// The matrix of a chain whose spring i has the stiffness k(i).
  template <class T, class M, class K>
  static void chain(M&& matrix, const K& k) {
    for (std::size_t row = 0; row < size; ++row)
      for (std::size_t column = 0; column < size; ++column)
        matrix(row, column) = T(row + masses == column ? 1 : 0);
    for (std::size_t i = 0; i < masses; ++i) {
      matrix(i + masses, i) = -(k(i) + k(i + 1));
      if (i > 0) matrix(i + masses, i - 1) = k(i);
      if (i + 1 < masses) matrix(i + masses, i + 1) = k(i + 1);
    }
  }
};

}  // namespace odemark
