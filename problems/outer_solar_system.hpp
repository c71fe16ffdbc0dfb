// The sun, the four giant planets and Pluto over centuries: energies must not drift.
#pragma once
#include "problems/gravity.hpp"
#include "problems/numbered.hpp"

namespace odemark {

/// State: heliocentric positions (AU) at the start of 5 September 1994, then velocities (AU per day); the sun
/// carries the masses of the inner planets.
template <class Real = double>
struct OuterSolarSystem {
  static constexpr std::string_view id = "outer_solar_system";
  static constexpr std::string_view title = "Outer solar system";
  static constexpr std::string_view equations =
      "ri'' = sum over j of G mj (rj - ri)/|rj - ri|^3 for the sun, Jupiter, Saturn, Uranus, Neptune, Pluto";
  static constexpr std::string_view source =
      "E. Hairer, C. Lubich, G. Wanner, Geometric Numerical Integration, 2nd ed. (Springer, 2006), I.2.4";
  static constexpr std::size_t bodies = 6;
  using Bodies = Gravity<bodies, 3>;
  static constexpr std::size_t size = Bodies::size;
  static constexpr std::array<Component, size> components{
      {{"sun x", "AU"},        {"sun y", "AU"},        {"sun z", "AU"},        {"Jupiter x", "AU"},
       {"Jupiter y", "AU"},    {"Jupiter z", "AU"},    {"Saturn x", "AU"},     {"Saturn y", "AU"},
       {"Saturn z", "AU"},     {"Uranus x", "AU"},     {"Uranus y", "AU"},     {"Uranus z", "AU"},
       {"Neptune x", "AU"},    {"Neptune y", "AU"},    {"Neptune z", "AU"},    {"Pluto x", "AU"},
       {"Pluto y", "AU"},      {"Pluto z", "AU"},      {"sun vx", "AU/d"},     {"sun vy", "AU/d"},
       {"sun vz", "AU/d"},     {"Jupiter vx", "AU/d"}, {"Jupiter vy", "AU/d"}, {"Jupiter vz", "AU/d"},
       {"Saturn vx", "AU/d"},  {"Saturn vy", "AU/d"},  {"Saturn vz", "AU/d"},  {"Uranus vx", "AU/d"},
       {"Uranus vy", "AU/d"},  {"Uranus vz", "AU/d"},  {"Neptune vx", "AU/d"}, {"Neptune vy", "AU/d"},
       {"Neptune vz", "AU/d"}, {"Pluto vx", "AU/d"},   {"Pluto vy", "AU/d"},   {"Pluto vz", "AU/d"}}};
  static constexpr std::array<std::string_view, 7> invariant_names{
      "energy", "momentum_x", "momentum_y", "momentum_z", "spin_yz", "spin_zx", "spin_xy"};
  static constexpr bool force_depends_on_velocity = false;

  Real G = Real(295912208286) / 1000000000000000, t_end = 10000;

  static constexpr auto parameters() {
    using P = Parameter<OuterSolarSystem, Real>;
    return std::array{
        P{"G", "AU^3/d^2", "gravitational parameter of the sun alone", &OuterSolarSystem::G, positive},
        P{"t_end", "d", "end of the interval", &OuterSolarSystem::t_end, positive}};
  }
  static constexpr std::array presets{
      Preset{"outer_solar_system", "G=2.95912208286e-4", "27 years: two revolutions of Jupiter"}};

  /// The sun is hardly moved by all the others: its own scale is their share of the motion.
  std::array<double, size> scale() const {
    std::array<double, size> out{};
    for (std::size_t i = 0; i < Bodies::half; ++i)
      out[i] = i < 3 ? 0.01 : 5, out[i + Bodies::half] = i < 3 ? 1e-5 : 5e-3;
    return out;
  }
  double suggested_dt() const { return 50; }

  template <class T>
  void initial(T* y) const {
    // 1e-7 AU; 1e-8 AU/d
    constexpr std::array<int, Bodies::half> places{0,          0,          0,         -35023653,  -38169847,
                                                   -15507963,  90755314,   -30458353, -16483708,  83101420,
                                                   -162901086, -72521278,  114707666, -257294829, -108169456,
                                                   -155387357, -252225594, -31902382};
    constexpr std::array<int, Bodies::half> speeds{0,      0,      0,      565429, -412490, -190589,
                                                   168318, 483525, 192462, 354178, 137102,  55029,
                                                   288930, 114527, 39677,  276725, -170702, -136504};
    for (std::size_t i = 0; i < Bodies::half; ++i) {
      y[i] = T(Real(places[i]) / Real(10000000));
      y[i + Bodies::half] = T(Real(speeds[i]) / Real(100000000));
    }
  }
  template <class T>
  void acceleration(const T&, const T* y, T* a) const {
    Bodies::acceleration(masses<T>(), y, a);
  }
  template <class T>
  void rhs(const T& t, const T* y, T* dydt) const {
    for (std::size_t i = 0; i < Bodies::half; ++i) dydt[i] = y[i + Bodies::half];
    acceleration(t, y, dydt + Bodies::half);
  }
  template <class T, class J>
  void jacobian(const T&, const T* y, J&& j) const {
    Bodies::jacobian(masses<T>(), y, j);
  }
  template <class T>
  void invariants(const T* y, T* out) const {
    const auto m = masses<T>();
    out[0] = Bodies::energy(m, y);
    for (std::size_t k = 0; k < 3; ++k) {
      out[1 + k] = Bodies::momentum(m, y, k);
      out[4 + k] = Bodies::spin(m, y, (k + 1) % 3, (k + 2) % 3);
    }
  }

 private:
  /// In masses of the sun without its inner planets, as published.
  template <class T>
  std::array<T, bodies> masses() const {
    const auto m = [this](long long numerator, long long denominator) {
      return T(G * (Real(numerator) / Real(denominator)));
    };
    return {m(100000597682, 100000000000),      m(954786104043, 1000000000000000),
            m(285583733151, 1000000000000000),  m(437273164546, 10000000000000000),
            m(517759138449, 10000000000000000), m(1, 130000000)};
  }
};

}  // namespace odemark
