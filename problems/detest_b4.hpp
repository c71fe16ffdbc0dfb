// A curve that winds round a torus: three coupled components, the square root of a sum of squares, known
// exactly.
#pragma once
#include "problems/family.hpp"

namespace odemark {

/// In cylindrical coordinates the angle grows at the rate 1, y3' is its cosine and the radius falls at the
/// rate y3. From (3, 0, 0) the curve stays on the torus (r - 2)^2 + y3^2 = 1.
template <class Real = double>
struct DetestB4 {
  static constexpr std::string_view id = "detest_b4";
  static constexpr std::string_view title = "Curve on a torus (DETEST B4)";
  static constexpr std::string_view equations =
      "y1' = -y2 - y1 y3/r;  y2' = y1 - y2 y3/r;  y3' = y1/r,  r = sqrt(y1^2 + y2^2)";
  static constexpr std::string_view source =
      "B4 of DETEST, T. E. Hull et al., SIAM J. Numer. Anal. 9 (1972) 603-637, doi:10.1137/0709052";
  static constexpr std::size_t size = 3;
  static constexpr std::array<Component, size> components{{{"y1", ""}, {"y2", ""}, {"y3", ""}}};
  static constexpr std::array<std::string_view, 1> invariant_names{"height_over_sine"};

  Real radius = 3, t_end = 20;

  static constexpr auto parameters() {
    using P = Parameter<DetestB4, Real>;
    return std::array{P{"radius", "", "initial distance from the axis", &DetestB4::radius,
                        Range{.lowest = 2, .open_below = true}},
                      P{"t_end", "", "end of the interval", &DetestB4::t_end, positive}};
  }
  static constexpr std::array presets{
      Preset{"detest_b4", "", "as published: three times round"},
      Preset{"detest_b4_tight", "radius=2.125", "past the axis at a distance of 1/8: a tight inner turn"}};

  std::array<double, size> scale() const { return {double(radius), double(radius), 1}; }
  double suggested_dt() const { return 0.0625 * (double(radius) - 2); }

  template <class T>
  void initial(T* y) const {
    y[0] = T(radius), y[1] = T(0), y[2] = T(0);
  }
  template <class T>
  void rhs(const T&, const T* y, T* dydt) const {
    using std::sqrt;
    const T r = sqrt(y[0] * y[0] + y[1] * y[1]);
    dydt[0] = -y[1] - y[0] * y[2] / r;
    dydt[1] = y[0] - y[1] * y[2] / r;
    dydt[2] = y[0] / r;
  }
  template <class T, class J>
  void jacobian(const T&, const T* y, J&& j) const {
    using std::sqrt;
    const T r = sqrt(y[0] * y[0] + y[1] * y[1]), cube = r * r * r;
    j(0, 0) = -(y[1] * y[1] * y[2] / cube), j(0, 1) = y[0] * y[1] * y[2] / cube - 1, j(0, 2) = -(y[0] / r);
    j(1, 0) = y[0] * y[1] * y[2] / cube + 1, j(1, 1) = -(y[0] * y[0] * y[2] / cube), j(1, 2) = -(y[1] / r);
    j(2, 0) = y[1] * y[1] / cube, j(2, 1) = -(y[0] * y[1] / cube), j(2, 2) = T(0);
  }
  /// The exact flow: y0 is the state at t = 0.
  template <class T>
  void exact(const T& t, const T* y0, T* y) const {
    using std::cos, std::sin, std::sqrt;
    const T r0 = sqrt(y0[0] * y0[0] + y0[1] * y0[1]), c0 = y0[0] / r0, s0 = y0[1] / r0;
    const T c = c0 * cos(t) - s0 * sin(t), s = s0 * cos(t) + c0 * sin(t);
    const T r = r0 - (y0[2] - s0) * t + c - c0;
    const T height = y0[2] + s - s0;
    y[0] = r * c, y[1] = r * s, y[2] = height;
  }
  template <class T>
  void invariants(const T* y, T* out) const {
    using std::sqrt;
    out[0] = y[2] - y[1] / sqrt(y[0] * y[0] + y[1] * y[1]);
  }
};

}  // namespace odemark
