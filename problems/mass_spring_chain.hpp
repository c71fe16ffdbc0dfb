// A chain of 32 masses between walls: a wide spectrum, of which only the slow end matters.
#pragma once
#include <algorithm>

#include "problems/family.hpp"
#include "problems/numbered.hpp"

namespace odemark {

/// State (x1 .. x32, v1 .. v32): displacements and rates. Plucked: mass 8 held aside and let go, which stirs
/// every mode.
template <class Real = double>
struct MassSpringChain {
  static constexpr std::string_view id = "mass_spring_chain";
  static constexpr std::string_view title = "Chain of 32 masses and springs";
  static constexpr std::string_view equations = "m xi'' = k (x(i-1) - 2 xi + x(i+1)),  x0 = x33 = 0";
  static constexpr std::string_view source =
      "J.-L. Lagrange, Mecanique analytique (1788); H. Goldstein, Classical Mechanics, 2nd ed. "
      "(Addison-Wesley, 1980), "
      "12-1";
  static constexpr std::size_t masses = 32, size = 2 * masses;
  static constexpr auto components = joined(numbered<"x", masses>("m"), numbered<"v", masses>("m/s"));
  static constexpr std::array<std::string_view, 1> invariant_names{"energy"};
  static constexpr bool force_depends_on_velocity = false;

  Real k = 10000, m = Real(1) / 64, pluck = 1, t_end = Real(1) / 8;

  static constexpr auto parameters() {
    using P = Parameter<MassSpringChain, Real>;
    return std::array{P{"k", "N/m", "stiffness of a spring", &MassSpringChain::k, positive},
                      P{"m", "kg", "a mass", &MassSpringChain::m, positive},
                      P{"pluck", "m", "initial displacement of mass 8", &MassSpringChain::pluck},
                      P{"t_end", "s", "end of the interval", &MassSpringChain::t_end, positive}};
  }
  static constexpr std::array presets{
      Preset{"mass_spring_chain", "",
             "1.5 periods of mode 1, 32 of mode 32 at 1600 rad/s: only the slow ones are of interest"}};

  std::array<double, size> scale() const {
    const double x = std::max(std::abs(double(pluck)), 1e-3);
    std::array<double, size> all;
    for (std::size_t i = 0; i < masses; ++i) {
      all[i] = x;
      all[i + masses] = 0.1 * x * std::sqrt(double(k) / double(m));
    }
    return all;
  }
  double suggested_dt() const { return 0.0625 * std::sqrt(double(m) / double(k)); }

  template <class T>
  void initial(T* y) const {
    for (std::size_t i = 1; i <= masses; ++i) {
      y[i - 1] = T(pluck) * (i <= 8 ? T(int(i)) / 8 : T(int(masses + 1 - i)) / T(int(masses + 1 - 8)));
      y[i - 1 + masses] = T(0);
    }
  }
  template <class T>
  void acceleration(const T&, const T* y, T* a) const {
    const T rate = T(k) / T(m);
    for (std::size_t i = 0; i < masses; ++i) {
      T bend = -2 * y[i];
      if (i > 0) bend += y[i - 1];
      if (i + 1 < masses) bend += y[i + 1];
      a[i] = rate * bend;
    }
  }
  template <class T>
  void rhs(const T& t, const T* y, T* dydt) const {
    for (std::size_t i = 0; i < masses; ++i) dydt[i] = y[i + masses];
    acceleration(t, y, dydt + masses);
  }
  template <class T, class J>
  void jacobian(const T&, const T*, J&& j) const {
    linear_part<T>(j);
  }
  template <class T, class L>
  void linear_part(L&& l) const {
    const T rate = T(k) / T(m);
    for (std::size_t row = 0; row < masses; ++row)
      for (std::size_t column = 0; column < size; ++column) {
        l(row, column) = column == row + masses ? T(1) : T(0);
        l(row + masses, column) = column == row                            ? T(-2 * rate)
                                  : column == row + 1 || column + 1 == row ? T(column < masses ? rate : T(0))
                                                                           : T(0);
      }
  }
  /// The same system with every drive removed: 0 is its fixed point.
  MassSpringChain homogeneous() const { return *this; }

  /// The exact flow, mode by mode: y0 is the state at t = 0.
  template <class T>
  void exact(const T& t, const T* y0, T* y) const {
    using std::atan, std::cos, std::sin, std::sqrt;
    const T quarter = 2 * atan(T(1));
    T sines[period];
    fill_sines(sines);
    std::array<T, size> out;
    for (T& each : out) each = T(0);
    for (std::size_t mode = 1; mode <= masses; ++mode) {
      T x = T(0), v = T(0);
      for (std::size_t i = 1; i <= masses; ++i) {
        x += y0[i - 1] * sines[mode * i % period];
        v += y0[i - 1 + masses] * sines[mode * i % period];
      }
      const T w = 2 * sqrt(T(k) / T(m)) * sin(quarter / T(int(masses + 1)) * T(int(mode))), c = cos(w * t),
              s = sin(w * t);
      const T xt = (x * c + v / w * s) * 2 / T(int(masses + 1)),
              vt = (v * c - x * w * s) * 2 / T(int(masses + 1));
      for (std::size_t i = 1; i <= masses; ++i) {
        out[i - 1] += xt * sines[mode * i % period];
        out[i - 1 + masses] += vt * sines[mode * i % period];
      }
    }
    std::copy(out.begin(), out.end(), y);
  }
  template <class T>
  void invariants(const T* y, T* out) const {
    T moving = T(0), stretched = y[0] * y[0] + y[masses - 1] * y[masses - 1];
    for (std::size_t i = 0; i < masses; ++i) moving += y[i + masses] * y[i + masses];
    for (std::size_t i = 1; i < masses; ++i) stretched += (y[i] - y[i - 1]) * (y[i] - y[i - 1]);
    out[0] = (T(m) * moving + T(k) * stretched) / 2;
  }

 private:
  static constexpr std::size_t period = 2 * (masses + 1);
  /// sin(q pi/33) for a whole period; those of an angle beyond a quarter by symmetry.
  template <class T>
  static void fill_sines(T* sines) {
    using std::atan, std::sin;
    const T unit = 4 * atan(T(1)) / T(int(masses + 1));
    for (std::size_t q = 0; q < period; ++q) {
      const std::size_t half = q % (masses + 1), least = std::min(half, masses + 1 - half);
      const T s = sin(unit * T(int(least)));
      sines[q] = q > masses ? T(-s) : s;
    }
  }
};

}  // namespace odemark
