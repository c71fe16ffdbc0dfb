// A pendulum upside down on a cart: it falls, and takes the cart along.
#pragma once
#include <algorithm>

#include "problems/family.hpp"

namespace odemark {

/// State (x, a, v, w): cart, angle from upright, and their rates. No friction, no control.
template <class Real = double>
struct InvertedPendulum {
  static constexpr std::string_view id = "inverted_pendulum";
  static constexpr std::string_view title = "Inverted pendulum on a cart";
  static constexpr std::string_view equations =
      "(M + m) x'' + m L (a'' cos a - a'^2 sin a) = 0;  L a'' + x'' cos a = g sin a";
  static constexpr std::string_view source =
      "K. J. Astrom, R. M. Murray, Feedback Systems (Princeton, 2008), example 2.1; A. G. Barto, R. S. "
      "Sutton, C. W. "
      "Anderson, IEEE Trans. Syst. Man Cybern. 13 (1983) 834-846, doi:10.1109/TSMC.1983.6313077";
  static constexpr std::size_t size = 4;
  static constexpr std::array<Component, size> components{
      {{"x", "m"}, {"a", "rad"}, {"v", "m/s"}, {"w", "rad/s"}}};
  static constexpr std::array<std::string_view, 2> invariant_names{"energy", "momentum"};
  static constexpr bool force_depends_on_velocity = true;

  Real M = 1, m = Real(1) / 4, L = 1, g = Real(157) / 16, a0 = Real(1) / 64, w0 = 0, t_end = 4;

  static constexpr auto parameters() {
    using P = Parameter<InvertedPendulum, Real>;
    return std::array{P{"M", "kg", "mass of the cart", &InvertedPendulum::M, positive},
                      P{"m", "kg", "mass at the tip", &InvertedPendulum::m, positive},
                      P{"L", "m", "length of the rod", &InvertedPendulum::L, positive},
                      P{"g", "m/s^2", "gravity", &InvertedPendulum::g, not_negative},
                      P{"a0", "rad", "initial angle from upright", &InvertedPendulum::a0},
                      P{"w0", "rad/s", "initial rate of the angle", &InvertedPendulum::w0},
                      P{"t_end", "s", "end of the interval", &InvertedPendulum::t_end, positive}};
  }
  static constexpr std::array presets{
      Preset{"inverted_pendulum", "", "falls through, all the way round and back"},
      Preset{"inverted_pendulum_light_cart", "M=1/16,m=1,a0=0.5", "the cart is flung about by the weight"},
      Preset{"inverted_pendulum_turning", "w0=8,a0=0", "turns over for ever"}};

  std::array<double, size> scale() const {
    const double w = std::max(std::sqrt(double(g) / double(L)), std::abs(double(w0)));
    return {double(L), 1, double(L) * w, w};
  }
  /// A cart that is light for its load is thrown the faster.
  double suggested_dt() const { return 0.03125 / scale()[3] * double(M) / (double(M) + double(m)); }

  template <class T>
  void initial(T* y) const {
    y[0] = T(0), y[1] = T(a0), y[2] = T(0), y[3] = T(w0);
  }
  template <class T>
  void acceleration(const T&, const T* y, T* out) const {
    using std::cos, std::sin;
    const T s = sin(y[1]), c = cos(y[1]);
    out[0] = T(m) * s * (T(L) * y[3] * y[3] - T(g) * c) / (T(M) + T(m) * s * s);
    out[1] = (T(g) * s - out[0] * c) / T(L);
  }
  template <class T>
  void rhs(const T& t, const T* y, T* dydt) const {
    dydt[0] = y[2], dydt[1] = y[3];
    acceleration(t, y, &dydt[2]);
  }
  template <class T>
  void invariants(const T* y, T* out) const {
    using std::cos;
    const T c = cos(y[1]), tip = T(L) * y[3], both = T(M) + T(m);
    out[0] = both * y[2] * y[2] / 2 + T(m) * (y[2] * tip * c + tip * tip / 2 + T(g) * T(L) * c);
    out[1] = both * y[2] + T(m) * tip * c;
  }
};

}  // namespace odemark
