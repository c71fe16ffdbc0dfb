// A chain of any number of masses and springs: what a step costs when nothing but the size grows.
#pragma once
#include <algorithm>
#include <vector>

#include "problems/family.hpp"
#include "problems/standing_waves.hpp"

namespace odemark {

/// State (x1 .. xn, v1 .. vn): displacements and rates. It starts at rest as two standing waves about sixteen
/// and six masses long, whatever n, so that the time scale does not depend on n either.
template <class Real = double>
struct SpringChain {
  static constexpr std::string_view id = "spring_chain";
  static constexpr std::string_view title = "Chain of n masses and springs";
  static constexpr std::string_view equations =
      "m xi'' = k (x(i-1) - 2 xi + x(i+1)), i = 1 .. n, x0 = x(n+1) = 0;  xi(0) = pluck (sin(p i pi/(n + 1)) "
      "+ sin(q i pi/(n + 1))/4), p = max(1, (n + 1)/8), q = max(1, (n + 1)/3) rounded down, xi'(0) = 0";
  static constexpr std::string_view source =
      "J.-L. Lagrange, Mecanique analytique (1788); H. Goldstein, Classical Mechanics, 2nd ed. "
      "(Addison-Wesley, 1980), 12-1";
  static constexpr std::array<Component, 2> component_groups{{{"x", "m"}, {"v", "m/s"}}};
  static constexpr std::array<std::string_view, 1> invariant_names{"energy"};
  static constexpr bool force_depends_on_velocity = false;

  Real n = 10, k = 100, m = Real(1) / 64, pluck = 1, t_end = 1;

  static constexpr auto parameters() {
    using P = Parameter<SpringChain, Real>;
    return std::array{
        P{"n", "", "number of masses", &SpringChain::n, {.lowest = 1, .highest = 1e6, .whole = true}},
        P{"k", "N/m", "stiffness of a spring", &SpringChain::k, positive},
        P{"m", "kg", "a mass", &SpringChain::m, positive},
        P{"pluck", "m", "amplitude of the longer wave", &SpringChain::pluck, positive},
        P{"t_end", "s", "end of the interval", &SpringChain::t_end, positive}};
  }
  static constexpr std::array presets{
      Preset{"spring_chain", "", "10 masses: the waves turn 4 and 10 times, the fastest mode 25 times"},
      Preset{"spring_chain_1000", "n=1000", "the same in 1000 masses: the state has left the first cache"},
      Preset{"spring_chain_100000", "n=100000",
             "the same in 100000 masses: the state has left all caches, and only linear cost gets through"}};

  std::size_t masses() const { return static_cast<std::size_t>(static_cast<double>(n)); }
  std::size_t size() const { return 2 * masses(); }
  /// Of the acceleration: a mass feels its neighbours.
  Bandwidth bandwidth() const { return {1, 1}; }
  std::vector<double> scale() const {
    const double x = static_cast<double>(pluck);
    std::vector<double> all(size(), x * turning());
    std::fill_n(all.begin(), masses(), x);
    return all;
  }
  double suggested_dt() const { return std::min(0.0625 / turning(), static_cast<double>(t_end)); }

  template <class T>
  void initial(T* y) const {
    for (std::size_t i = 1; i <= masses(); ++i) {
      y[i - 1] = wave(i, T(pluck), T(pluck) / 4);
      y[i - 1 + masses()] = T(0);
    }
  }
  template <class T>
  void acceleration(const T&, const T* y, T* a) const {
    const T r = rate<T>();
    second_difference(masses(), y, a);
    for (std::size_t i = 0; i < masses(); ++i) a[i] = r * a[i];
  }
  template <class T>
  void rhs(const T& t, const T* y, T* dydt) const {
    for (std::size_t i = 0; i < masses(); ++i) dydt[i] = y[i + masses()];
    acceleration(t, y, dydt + masses());
  }
  template <class T, class J>
  void jacobian(const T&, const T*, J&& j) const {
    linear_part<T>(j);
  }
  template <class T, class L>
  void linear_part(L&& l) const {
    for (std::size_t i = 0; i < masses(); ++i) l(i, masses() + i) = T(1);
    second_difference_matrix(masses(), rate<T>(), masses(), l);
  }
  /// The same system with every drive removed: 0 is its fixed point.
  SpringChain homogeneous() const { return *this; }

  /// The exact flow, mode by mode: y0 is the state at t = 0.
  template <class T>
  void exact(const T& t, const T* y0, T* y) const {
    using std::cos, std::sin;
    const std::size_t half = masses();
    auto x = mode_amplitudes(half, y0), v = mode_amplitudes(half, y0 + half);
    for (std::size_t mode = 1; mode <= half; ++mode) {
      const T w = turning<T>(mode), c = cos(w * t), s = sin(w * t);
      const T x0 = x[mode - 1], v0 = v[mode - 1];
      x[mode - 1] = x0 * c + v0 / w * s;
      v[mode - 1] = v0 * c - x0 * w * s;
    }
    sum_of_modes(half, x, y);
    sum_of_modes(half, v, y + half);
  }
  /// The solution that starts as initial() does, at the components named.
  template <class T>
  void exact_at(const T& t, const std::vector<std::size_t>& places, T* y) const {
    using std::cos, std::sin;
    const T w = turning<T>(longer()), w_short = turning<T>(shorter());
    const T x = T(pluck) * cos(w * t), x_short = T(pluck) / 4 * cos(w_short * t);
    const T v = -(T(pluck) * w * sin(w * t)), v_short = -(T(pluck) / 4 * w_short * sin(w_short * t));
    for (std::size_t p = 0; p < places.size(); ++p)
      y[p] =
          places[p] < masses() ? wave(places[p] + 1, x, x_short) : wave(places[p] - masses() + 1, v, v_short);
  }
  /// How far a component moves, at any time, where every displacement at the start moves by at most 1, and
  /// where one does: in the norm of the modes no displacement grows, and no rate beyond 2 sqrt(k/m) times it.
  double spread(std::size_t component) const {
    return std::sqrt(static_cast<double>(masses())) * reach(component);
  }
  double reach(std::size_t component) const { return component < masses() ? 1 : 2 * turning(); }

  template <class T>
  void invariants(const T* y, T* out) const {
    const std::size_t half = masses();
    T moving = T(0), stretched = y[0] * y[0] + y[half - 1] * y[half - 1];
    for (std::size_t i = 0; i < half; ++i) moving += y[i + half] * y[i + half];
    for (std::size_t i = 1; i < half; ++i) stretched += (y[i] - y[i - 1]) * (y[i] - y[i - 1]);
    out[0] = (T(m) * moving + T(k) * stretched) / 2;
  }

 private:
  std::size_t longer() const { return std::max<std::size_t>(1, (masses() + 1) / 8); }
  std::size_t shorter() const { return std::max<std::size_t>(1, (masses() + 1) / 3); }
  /// sqrt(k/m), rad/s
  double turning() const { return std::sqrt(static_cast<double>(k) / static_cast<double>(m)); }
  /// Of a mode.
  template <class T>
  T turning(std::size_t mode) const {
    using std::sqrt;
    return sqrt(rate<T>()) * mode_number<T>(mode, masses());
  }
  template <class T>
  T wave(std::size_t i, const T& a, const T& b) const {
    return a * mode_sine<T>(i, longer(), masses()) + b * mode_sine<T>(i, shorter(), masses());
  }
  template <class T>
  T rate() const {
    return T(k) / T(m);
  }
};

}  // namespace odemark
