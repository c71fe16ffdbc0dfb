// A quarter of a car on a washboard: body, suspension, wheel, tyre.
#pragma once
#include <algorithm>

#include "problems/family.hpp"

namespace odemark {

/// State (xs, xu, vs, vu): heights of body and wheel above where they rest, and their rates. The wheel hops
/// at sqrt((kt + ks)/mu), ten times as fast as the body bounces.
template <class Real = double>
struct QuarterCar {
  static constexpr std::string_view id = "quarter_car";
  static constexpr std::string_view title = "Quarter car";
  static constexpr std::string_view equations =
      "ms xs'' = -ks (xs - xu) - cs (xs' - xu');  mu xu'' = ks (xs - xu) + cs (xs' - xu') - kt (xu - road),  "
      "road = A sin W t";
  static constexpr std::string_view source =
      "T. D. Gillespie, Fundamentals of Vehicle Dynamics (SAE, 1992), ch. 5; R. N. Jazar, Vehicle Dynamics "
      "(Springer, "
      "2008), ch. 15";
  static constexpr std::size_t size = 4;
  static constexpr std::array<Component, size> components{
      {{"xs", "m"}, {"xu", "m"}, {"vs", "m/s"}, {"vu", "m/s"}}};
  static constexpr bool force_depends_on_velocity = true;

  Real ms = 350, mu = 40, ks = 22000, cs = 1500, kt = 200000, A = Real(1) / 64, W = 12, xs0 = 0, t_end = 4;

  static constexpr auto parameters() {
    using P = Parameter<QuarterCar, Real>;
    return std::array{P{"ms", "kg", "mass of the body over one wheel", &QuarterCar::ms, positive},
                      P{"mu", "kg", "mass of the wheel", &QuarterCar::mu, positive},
                      P{"ks", "N/m", "stiffness of the suspension", &QuarterCar::ks, positive},
                      P{"cs", "N s/m", "its damping", &QuarterCar::cs, positive},
                      P{"kt", "N/m", "stiffness of the tyre", &QuarterCar::kt, positive},
                      P{"A", "m", "height of the waves of the road", &QuarterCar::A},
                      P{"W", "rad/s", "their rate as driven over", &QuarterCar::W, positive},
                      P{"xs0", "m", "initial height of the body", &QuarterCar::xs0},
                      P{"t_end", "s", "end of the interval", &QuarterCar::t_end, positive}};
  }
  static constexpr std::array presets{
      Preset{"quarter_car", "", "slow waves: the body follows"},
      Preset{"quarter_car_hop", "A=1/256,W=75,t_end=1", "driven where the wheel hops"},
      Preset{"quarter_car_dropped", "A=0,xs0=0.125,kt=2000000,t_end=2",
             "let down on tyres ten times as hard: stiff, with nothing fast to see"}};

  std::array<double, size> scale() const {
    const double x = std::max({std::abs(double(A)), std::abs(double(xs0)), 1e-3}),
                 rate = std::max(double(W), std::sqrt(double(ks) / double(ms)));
    return {x, x, x * rate, 2 * x * rate};
  }
  double suggested_dt() const {
    return 0.125 /
           std::max(double(W), std::sqrt((double(kt) + double(ks)) / double(mu)) + double(cs) / double(mu));
  }

  template <class T>
  void initial(T* y) const {
    y[0] = T(xs0), y[1] = T(0), y[2] = T(0), y[3] = T(0);
  }
  template <class T>
  void acceleration(const T& t, const T* y, T* a) const {
    using std::sin;
    const T strut = T(ks) * (y[0] - y[1]) + T(cs) * (y[2] - y[3]);
    a[0] = -strut / T(ms);
    a[1] = (strut - T(kt) * (y[1] - T(A) * sin(T(W) * t))) / T(mu);
  }
  template <class T>
  void rhs(const T& t, const T* y, T* dydt) const {
    dydt[0] = y[2], dydt[1] = y[3];
    acceleration(t, y, &dydt[2]);
  }
  template <class T, class J>
  void jacobian(const T&, const T*, J&& j) const {
    linear_part<T>(j);
  }
  template <class T, class L>
  void linear_part(L&& l) const {
    for (std::size_t row = 0; row < 2; ++row)
      for (std::size_t column = 0; column < size; ++column) l(row, column) = column == row + 2 ? T(1) : T(0);
    l(2, 0) = -T(ks) / T(ms), l(2, 1) = T(ks) / T(ms), l(2, 2) = -T(cs) / T(ms), l(2, 3) = T(cs) / T(ms);
    l(3, 0) = T(ks) / T(mu), l(3, 1) = -(T(ks) + T(kt)) / T(mu), l(3, 2) = T(cs) / T(mu),
         l(3, 3) = -T(cs) / T(mu);
  }
  /// The same system with every drive removed: 0 is its fixed point.
  QuarterCar homogeneous() const {
    QuarterCar parked = *this;
    parked.A = 0;
    return parked;
  }
};

}  // namespace odemark
