// Heat in a rod: the stiffness that grows with the square of the resolution.
#pragma once
#include "problems/numbered.hpp"
#include "problems/sine_modes.hpp"

namespace odemark {

/// State: the temperature at 31 inner points of a rod between two cold ends, central differences. The left
/// half starts hot, so every mode takes part.
template <class Real = double>
struct Heat1d {
  static constexpr std::string_view id = "heat_1d";
  static constexpr std::string_view title = "Heat in a rod, 31 points";
  static constexpr std::string_view equations =
      "ui' = D (u(i-1) - 2 ui + u(i+1))/dx^2, dx = length/32, u0 = u32 = 0;  ui(0) = u_hot for i < 16, else "
      "0";
  static constexpr std::string_view source =
      "W. Hundsdorfer, J. G. Verwer, Numerical Solution of Time-Dependent Advection-Diffusion-Reaction "
      "Equations (Springer, 2003), I.3, doi:10.1007/978-3-662-09017-6";
  static constexpr std::size_t size = 31;
  static constexpr std::array<Component, size> components = numbered<"u", size>("K");

  Real D = 1, length = 1, u_hot = 1, t_end = Real(1) / 8;

  static constexpr auto parameters() {
    using P = Parameter<Heat1d, Real>;
    return std::array{
        P{"D", "m^2/s", "diffusivity", &Heat1d::D, positive},
        P{"length", "m", "length of the rod", &Heat1d::length, positive},
        P{"u_hot", "K", "initial temperature of the left half above the ends", &Heat1d::u_hot, positive},
        P{"t_end", "s", "end of the interval", &Heat1d::t_end, positive}};
  }
  static constexpr std::array presets{
      Preset{"heat_1d", "", "rates from 10 to 4096 /s, all excited; the slowest mode is left at the end"},
      Preset{"heat_1d_short", "t_end=0.00390625", "the jump is still being smoothed"}};

  std::array<double, size> scale() const {
    std::array<double, size> hot;
    hot.fill(double(u_hot));
    return hot;
  }
  double suggested_dt() const { return 0.0625 / double(rate<Real>()); }

  template <class T>
  void initial(T* y) const {
    for (std::size_t i = 0; i < size; ++i) y[i] = i < size / 2 ? T(u_hot) : T(0);
  }
  template <class T>
  void rhs(const T&, const T* y, T* dydt) const {
    diffusion_rhs<size>(rate<T>(), y, dydt);
  }
  template <class T, class J>
  void jacobian(const T&, const T*, J&& j) const {
    linear_part<T>(j);
  }
  template <class T, class L>
  void linear_part(L&& l) const {
    diffusion_matrix<size>(rate<T>(), l);
  }
  /// The same system with every drive removed: 0 is its fixed point.
  Heat1d homogeneous() const { return *this; }
  /// The exact flow: y0 is the state at t = 0.
  template <class T>
  void exact(const T& t, const T* y0, T* y) const {
    diffusion_exact<size>(rate<T>(), t, y0, y);
  }

 private:
  /// D/dx^2
  template <class T>
  T rate() const {
    const T dx = T(length) / int(size + 1);
    return T(D) / (dx * dx);
  }
};

}  // namespace odemark
