// A spring that hardens: the frequency depends on the amplitude, so energy errors become phase errors.
#pragma once
#include "problems/elliptic.hpp"
#include "problems/family.hpp"

namespace odemark {

/// State (x, v), per mass.
template <class Real = double>
struct Duffing {
  static constexpr std::string_view id = "duffing";
  static constexpr std::string_view title = "Duffing's hard spring, free";
  static constexpr std::string_view equations = "x' = v;  v' = -alpha x - beta x^3";
  static constexpr std::string_view source =
      "D. F. Lawden, Elliptic Functions and Applications (Springer, 1989), 5.2, "
      "doi:10.1007/978-1-4757-3980-0";
  static constexpr std::size_t size = 2;
  static constexpr std::array<Component, size> components{{{"x", "m"}, {"v", "m/s"}}};
  static constexpr std::array<std::string_view, 1> invariant_names{"energy"};
  static constexpr bool force_depends_on_velocity = false;

  Real alpha = 1, beta = 1, x0 = 1, v0 = 0, t_end = 20;

  static constexpr auto parameters() {
    using P = Parameter<Duffing, Real>;
    return std::array{P{"alpha", "1/s^2", "linear stiffness over mass", &Duffing::alpha, not_negative},
                      P{"beta", "1/(m^2 s^2)", "cubic stiffness over mass", &Duffing::beta, positive},
                      P{"x0", "m", "initial displacement", &Duffing::x0},
                      P{"v0", "m/s", "initial velocity", &Duffing::v0},
                      P{"t_end", "s", "end of the interval", &Duffing::t_end, positive}};
  }
  static constexpr std::array presets{
      Preset{"duffing", "", "four periods of an amplitude at which both terms matter alike"},
      Preset{"duffing_long", "t_end=100", "twenty periods: phase errors add up"},
      Preset{"duffing_purely_cubic", "alpha=0,x0=0,v0=2,t_end=20",
             "no linear part at all: no frequency to fit"}};

  std::array<double, size> scale() const {
    const double x = amplitude(double(x0), double(v0));
    return x > 0 ? std::array<double, size>{x, x * rate(x)} : std::array<double, size>{1, 1};
  }
  double suggested_dt() const {
    const double fastest = rate(amplitude(double(x0), double(v0)));
    return 0.0625 / (fastest > 0 ? fastest : 1);
  }

  template <class T>
  void initial(T* y) const {
    y[0] = T(x0), y[1] = T(v0);
  }
  template <class T>
  void acceleration(const T&, const T* y, T* a) const {
    a[0] = -(T(alpha) + T(beta) * (y[0] * y[0])) * y[0];
  }
  template <class T>
  void rhs(const T& t, const T* y, T* dydt) const {
    dydt[0] = y[1];
    acceleration(t, y, &dydt[1]);
  }
  template <class T, class J>
  void jacobian(const T&, const T* y, J&& j) const {
    j(0, 0) = T(0), j(0, 1) = T(1);
    j(1, 0) = -(T(alpha) + 3 * T(beta) * (y[0] * y[0])), j(1, 1) = T(0);
  }
  template <class T, class L>
  void linear_part(L&& l) const {
    l(0, 0) = T(0), l(0, 1) = T(1);
    l(1, 0) = -T(alpha), l(1, 1) = T(0);
  }

  /// The exact flow: x is A cn(w t + phase) with w^2 = alpha + beta A^2 and the parameter
  /// m = beta A^2/(2 w^2). The phase enters by the addition theorems, through its cn and sn dn alone.
  template <class T>
  void exact(const T& t, const T* y0, T* y) const {
    using std::sqrt;
    const T A = amplitude(y0[0], y0[1]), w = rate(A);
    if (w == 0 || A == 0) {
      y[0] = y0[0] + t * y0[1], y[1] = y0[1];
      return;
    }
    const T m = T(beta) * A * A / (2 * w * w), c0 = y0[0] / A, sd0 = -(y0[1] / (A * w)), s0s0 = 1 - c0 * c0;
    const auto [s, c, d] = elliptic::jacobi(T(w * t), T(sqrt(1 - m)));
    const T below = 1 - m * s * s * s0s0, d0d0 = 1 - m * s0s0;
    y[0] = A * (c0 * c - sd0 * s * d) / below;
    const T product =
        s * d * c0 * d0d0 + sd0 * c * d * d - m * s * s * c * c0 * c0 * sd0 - m * s * d * c * c * c0 * s0s0;
    y[1] = -(A * w * product / (below * below));
  }
  /// Per mass.
  template <class T>
  void invariants(const T* y, T* out) const {
    const T x2 = y[0] * y[0];
    out[0] = (y[1] * y[1] + T(alpha) * x2) / 2 + T(beta) * (x2 * x2) / 4;
  }

 private:
  template <class T>
  T amplitude(const T& x, const T& v) const {
    using std::sqrt;
    const T x2 = x * x, energy4 = 2 * (v * v + T(alpha) * x2) + T(beta) * (x2 * x2);
    const T below = T(alpha) + sqrt(T(alpha) * T(alpha) + T(beta) * energy4);
    return below > 0 ? T(sqrt(energy4 / below)) : T(0);
  }
  template <class T>
  T rate(const T& A) const {
    using std::sqrt;
    return sqrt(T(alpha) + T(beta) * A * A);
  }
};

}  // namespace odemark
