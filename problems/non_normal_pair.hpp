// Two decaying modes that almost coincide in direction: growth before decay, which no eigenvalue tells.
#pragma once
#include <algorithm>

#include "problems/family.hpp"

namespace odemark {

template <class Real = double>
struct NonNormalPair {
  static constexpr std::string_view id = "non_normal_pair";
  static constexpr std::string_view title = "Non-normal pair";
  static constexpr std::string_view equations = "y1' = -a y1 + c y2;  y2' = -b y2";
  static constexpr std::string_view source =
      "L. N. Trefethen, M. Embree, Spectra and Pseudospectra (Princeton, 2005), ch. 14; own parameters";
  static constexpr std::size_t size = 2;
  static constexpr std::array<Component, size> components{{{"y1", ""}, {"y2", ""}}};

  Real a = 1, b = 2, c = 100, y1 = 0, y2 = 1, t_end = 10;

  static constexpr auto parameters() {
    using P = Parameter<NonNormalPair, Real>;
    return std::array{P{"a", "1/s", "decay rate of y1", &NonNormalPair::a, positive},
                      P{"b", "1/s", "decay rate of y2", &NonNormalPair::b, positive},
                      P{"c", "1/s", "coupling", &NonNormalPair::c},
                      P{"y1", "", "initial y1", &NonNormalPair::y1},
                      P{"y2", "", "initial y2", &NonNormalPair::y2},
                      P{"t_end", "s", "end of the interval", &NonNormalPair::t_end, positive}};
  }
  static constexpr std::array presets{
      Preset{"non_normal_pair", "", "grows 25-fold before it decays"},
      Preset{"non_normal_pair_defective", "b=1", "equal rates: a Jordan block"},
      Preset{"non_normal_pair_stiff", "a=1,b=1024,c=65536,t_end=4",
             "a fast mode that throws the slow one far out"}};

  std::array<double, size> scale() const {
    const double start = std::max(std::abs(double(y1)), std::abs(double(y2)));
    const double thrown = std::abs(double(c) * double(y2)) / (double(a) + double(b));
    return start > 0 ? std::array<double, size>{std::max(start, thrown), start}
                     : std::array<double, size>{1, 1};
  }
  double suggested_dt() const { return 0.0625 / std::max(double(a), double(b)); }

  template <class T>
  void initial(T* y) const {
    y[0] = T(y1), y[1] = T(y2);
  }
  template <class T>
  void rhs(const T&, const T* y, T* dydt) const {
    dydt[0] = T(c) * y[1] - T(a) * y[0];
    dydt[1] = -(T(b) * y[1]);
  }
  template <class T, class J>
  void jacobian(const T&, const T*, J&& j) const {
    linear_part<T>(j);
  }
  template <class T, class L>
  void linear_part(L&& l) const {
    l(0, 0) = -T(a), l(0, 1) = T(c);
    l(1, 0) = T(0), l(1, 1) = -T(b);
  }
  /// The same system with every drive removed: 0 is its fixed point.
  NonNormalPair homogeneous() const { return *this; }
  /// The exact flow: y0 is the state at t = 0.
  template <class T>
  void exact(const T& t, const T* y0, T* y) const {
    using std::exp, std::expm1;
    const T apart = T(b) - T(a), slow = exp(-(T(a) * t)), fast = exp(-(T(b) * t));
    const T between = apart == 0 ? T(t * slow) : T(-expm1(T(-(apart * t))) * slow / apart);
    const T second = y0[1];
    y[0] = y0[0] * slow + T(c) * second * between;
    y[1] = second * fast;
  }
};

}  // namespace odemark
