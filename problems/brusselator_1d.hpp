// The chemical clock along a tube: reaction and diffusion, stiffer with every grid point.
#pragma once
#include "problems/elliptic.hpp"
#include "problems/numbered.hpp"
#include "problems/sine_modes.hpp"

namespace odemark {

/// State: u at 15 inner points of the tube, then v; u = 1 and v = 3 at both ends.
template <class Real = double>
struct Brusselator1d {
  static constexpr std::string_view id = "brusselator_1d";
  static constexpr std::string_view title = "Brusselator with diffusion, 15 points";
  static constexpr std::string_view equations =
      "ui' = 1 + ui^2 vi - 4 ui + alpha (u(i-1) - 2 ui + u(i+1))/dx^2;  vi' = 3 ui - ui^2 vi + alpha (v(i-1) "
      "- 2 vi + "
      "v(i+1))/dx^2, dx = 1/16;  ui(0) = 1 + sin(2 pi xi), vi(0) = 3";
  static constexpr std::string_view source =
      "E. Hairer, G. Wanner, Solving Ordinary Differential Equations II, 2nd ed. (Springer, 1996), IV.1, "
      "doi:10.1007/978-3-642-05221-7";
  static constexpr std::size_t points = 15, size = 2 * points;
  static constexpr std::array<Component, size> components =
      joined(numbered<"u", points>(""), numbered<"v", points>(""));

  Real alpha = Real(1) / 50, t_end = 10;

  static constexpr auto parameters() {
    using P = Parameter<Brusselator1d, Real>;
    return std::array{P{"alpha", "", "diffusivity", &Brusselator1d::alpha, positive},
                      P{"t_end", "", "end of the interval", &Brusselator1d::t_end, positive}};
  }
  static constexpr std::array presets{
      Preset{"brusselator_1d", "alpha=0.02", "as in the book but for the number of points"},
      Preset{"brusselator_1d_stiff", "alpha=1,t_end=0.5", "diffusion fifty times as fast"}};

  std::array<double, size> scale() const {
    std::array<double, size> out{};
    for (std::size_t i = 0; i < size; ++i) out[i] = i < points ? 2 : 3;
    return out;
  }
  double suggested_dt() const { return 0.03125 / (5 + 2 * double(rate<Real>())); }

  template <class T>
  void initial(T* y) const {
    using std::sin;
    for (std::size_t i = 0; i < points; ++i) {
      y[i] = 1 + sin(2 * elliptic::pi<T>() * int(i + 1) / int(points + 1));
      y[i + points] = T(3);
    }
  }
  template <class T>
  void rhs(const T&, const T* y, T* dydt) const {
    const T d = rate<T>();
    diffusion_rhs<points>(d, y, dydt);
    diffusion_rhs<points>(d, y + points, dydt + points);
    for (const std::size_t end : {std::size_t(0), points - 1}) {
      dydt[end] = dydt[end] + d;
      dydt[end + points] = dydt[end + points] + 3 * d;
    }
    for (std::size_t i = 0; i < points; ++i) {
      const T made = y[i] * y[i] * y[i + points];
      dydt[i] = dydt[i] + (1 + made - 4 * y[i]);
      dydt[i + points] = dydt[i + points] + (3 * y[i] - made);
    }
  }
  template <class T, class J>
  void jacobian(const T&, const T* y, J&& j) const {
    linear_part<T>(j);
    for (std::size_t i = 0; i < points; ++i) {
      const std::size_t k = i + points;
      const T uv = 2 * y[i] * y[k], uu = y[i] * y[i];
      j(i, i) = j(i, i) + uv - 4, j(i, k) = uu;
      j(k, i) = 3 - uv, j(k, k) = j(k, k) - uu;
    }
  }
  /// Diffusion alone.
  template <class T, class L>
  void linear_part(L&& l) const {
    const T d = rate<T>();
    for (std::size_t row = 0; row < size; ++row)
      for (std::size_t column = 0; column < size; ++column) {
        const bool same = (row < points) == (column < points);
        l(row, column) = row == column                                      ? T(-(2 * d))
                         : same && (row + 1 == column || column + 1 == row) ? d
                                                                            : T(0);
      }
  }

 private:
  /// alpha/dx^2
  template <class T>
  T rate() const {
    return T(alpha) * int((points + 1) * (points + 1));
  }
};

}  // namespace odemark
