// Robertson's reaction: rates nine powers of ten apart, over eleven powers of ten of time.
#pragma once
#include "problems/family.hpp"

namespace odemark {

/// State (y1, y2, y3), shares of the total mass. A negative y2 makes the true solution run away: positivity
/// matters.
template <class Real = double>
struct Robertson {
  static constexpr std::string_view id = "robertson";
  static constexpr std::string_view title = "Robertson's chemical reaction";
  static constexpr std::string_view equations =
      "y1' = -k1 y1 + k3 y2 y3;  y2' = k1 y1 - k3 y2 y3 - k2 y2^2;  y3' = k2 y2^2";
  static constexpr std::string_view source =
      "H. H. Robertson, in J. Walsh (ed.), Numerical Analysis: An Introduction (Academic Press, 1966) "
      "178-182; to 1e11: "
      "F. Mazzia, C. Magherini, Test Set for Initial Value Problem Solvers, release 2.4 (2008), problem "
      "rober";
  static constexpr std::size_t size = 3;
  static constexpr std::array<Component, size> components{{{"y1", ""}, {"y2", ""}, {"y3", ""}}};
  static constexpr std::array<std::string_view, 1> invariant_names{"total_mass"};

  Real k1 = Real(1) / 25, k2 = 30000000, k3 = 10000, t_end = 40;

  static constexpr auto parameters() {
    using P = Parameter<Robertson, Real>;
    return std::array{P{"k1", "1/s", "rate of 1 -> 2", &Robertson::k1, not_negative},
                      P{"k2", "1/s", "rate of 2 + 2 -> 2 + 3", &Robertson::k2, not_negative},
                      P{"k3", "1/s", "rate of 2 + 3 -> 1 + 3", &Robertson::k3, not_negative},
                      P{"t_end", "s", "end of the interval", &Robertson::t_end, positive}};
  }
  static constexpr std::array presets{
      Preset{"robertson", "", "the first 40 s, past the fast transient"},
      Preset{"robertson_t4e5", "t_end=4e5", "four powers of ten further"},
      Preset{"robertson_long", "t_end=1e11", "to the end of the reaction: y2 falls to 8e-14"}};

  std::array<double, size> scale() const { return {1, 4e-5, 1}; }
  double suggested_dt() const { return 0x1p-11; }

  template <class T>
  void initial(T* y) const {
    y[0] = T(1), y[1] = T(0), y[2] = T(0);
  }
  template <class T>
  void rhs(const T&, const T* y, T* dydt) const {
    const T there = T(k1) * y[0], back = T(k3) * y[1] * y[2], on = T(k2) * y[1] * y[1];
    dydt[0] = back - there;
    dydt[1] = there - back - on;
    dydt[2] = on;
  }
  template <class T, class J>
  void jacobian(const T&, const T* y, J&& j) const {
    const T back2 = T(k3) * y[2], back3 = T(k3) * y[1], on2 = 2 * T(k2) * y[1];
    j(0, 0) = -T(k1), j(0, 1) = back2, j(0, 2) = back3;
    j(1, 0) = T(k1), j(1, 1) = -back2 - on2, j(1, 2) = -back3;
    j(2, 0) = T(0), j(2, 1) = on2, j(2, 2) = T(0);
  }
  template <class T>
  void invariants(const T* y, T* out) const {
    out[0] = y[0] + y[1] + y[2];
  }
};

}  // namespace odemark
