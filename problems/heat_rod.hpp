// Heat in a rod of any number of points: what implicit and stabilised methods are for, at any size.
#pragma once
#include <vector>

#include "problems/family.hpp"
#include "problems/standing_waves.hpp"

namespace odemark {

/// State: the temperature at n inner points between two cold ends. It starts as two smooth waves, so that the
/// solution is known at any point without the others; what is stiff is not excited.
template <class Real = double>
struct HeatRod {
  static constexpr std::string_view id = "heat_rod";
  static constexpr std::string_view title = "Heat in a rod of n points";
  static constexpr std::string_view equations =
      "ui' = D (u(i-1) - 2 ui + u(i+1))/dx^2, i = 1 .. n, dx = length/(n + 1), u0 = u(n+1) = 0;  ui(0) = "
      "u_hot (sin(pi i/(n + 1)) + sin(3 pi i/(n + 1))/4)";
  static constexpr std::string_view source =
      "W. Hundsdorfer, J. G. Verwer, Numerical Solution of Time-Dependent Advection-Diffusion-Reaction "
      "Equations (Springer, 2003), I.3, doi:10.1007/978-3-662-09017-6";
  static constexpr std::array<Component, 1> component_groups{{{"u", "K"}}};

  Real n = 10, D = 1, length = 1, u_hot = 1, t_end = Real(1) / 8;

  static constexpr auto parameters() {
    using P = Parameter<HeatRod, Real>;
    return std::array{
        P{"n", "", "number of points", &HeatRod::n, {.lowest = 1, .highest = 1e6, .whole = true}},
        P{"D", "m^2/s", "diffusivity", &HeatRod::D, positive},
        P{"length", "m", "length of the rod", &HeatRod::length, positive},
        P{"u_hot", "K", "amplitude of the first wave of temperature above the ends", &HeatRod::u_hot,
          positive},
        P{"t_end", "s", "end of the interval", &HeatRod::t_end, positive}};
  }
  static constexpr std::array presets{
      Preset{"heat_rod", "", "10 points: the fastest mode fades 48 times as fast as the slowest"},
      Preset{"heat_rod_1000", "n=1000", "1000 points: 4e5 times as fast, so that explicit steps are tiny"},
      Preset{"heat_rod_100000", "n=100000", "100000 points, 4e9 times: only linear cost gets through"}};

  std::size_t size() const { return static_cast<std::size_t>(static_cast<double>(n)); }
  Bandwidth bandwidth() const { return {1, 1}; }
  std::vector<double> scale() const { return std::vector<double>(size(), static_cast<double>(u_hot)); }
  /// A small part of the time in which the faster of the two waves fades, whatever n.
  double suggested_dt() const {
    const double l = static_cast<double>(length);
    const double slow = 0.0625 * l * l / (9.8696 * 9 * static_cast<double>(D));
    return std::min(slow, static_cast<double>(t_end));
  }

  template <class T>
  void initial(T* y) const {
    for (std::size_t i = 1; i <= size(); ++i) y[i - 1] = wave(i, first<T>(), second<T>());
  }
  template <class T>
  void rhs(const T&, const T* y, T* dydt) const {
    const T r = rate<T>();
    second_difference(size(), y, dydt);
    for (std::size_t i = 0; i < size(); ++i) dydt[i] = r * dydt[i];
  }
  template <class T, class J>
  void jacobian(const T&, const T*, J&& j) const {
    linear_part<T>(j);
  }
  template <class T, class L>
  void linear_part(L&& l) const {
    second_difference_matrix(size(), rate<T>(), 0, l);
  }
  /// The same system with every drive removed: 0 is its fixed point.
  HeatRod homogeneous() const { return *this; }

  /// The exact flow, mode by mode: y0 is the state at t = 0.
  template <class T>
  void exact(const T& t, const T* y0, T* y) const {
    auto amplitude = mode_amplitudes(size(), y0);
    for (std::size_t k = 1; k <= size(); ++k) amplitude[k - 1] = amplitude[k - 1] * fading(t, k);
    sum_of_modes(size(), amplitude, y);
  }
  /// The solution that starts as initial() does, at the components named.
  template <class T>
  void exact_at(const T& t, const std::vector<std::size_t>& places, T* y) const {
    const T a = first<T>() * fading(t, 1), b = second<T>() * fading(t, 3);
    for (std::size_t p = 0; p < places.size(); ++p) y[p] = wave(places[p] + 1, a, b);
  }
  /// How far a component moves, at any time, where every component of the initial state moves by at most 1,
  /// and where one does: no temperature leaves the range of those it began with.
  double spread(std::size_t) const { return 1; }
  double reach(std::size_t) const { return 1; }

 private:
  template <class T>
  T first() const {
    return T(u_hot);
  }
  template <class T>
  T second() const {
    return T(u_hot) / 4;
  }
  template <class T>
  T wave(std::size_t i, const T& a, const T& b) const {
    return a * mode_sine<T>(i, 1, size()) + b * mode_sine<T>(i, 3, size());
  }
  template <class T>
  T fading(const T& t, std::size_t k) const {
    using std::exp;
    const T number = mode_number<T>(k, size());
    return exp(-(rate<T>() * number * number * t));
  }
  /// D/dx^2
  template <class T>
  T rate() const {
    const T dx = T(length) / T(int(size() + 1));
    return T(D) / (dx * dx);
  }
};

}  // namespace odemark
