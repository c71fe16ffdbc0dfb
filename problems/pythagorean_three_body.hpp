// Burrau's problem: masses 3, 4 and 5 let go at the corners of a right triangle; close encounters one after
// the other until one body escapes.
#pragma once
#include "problems/family.hpp"
#include "problems/gravity.hpp"

namespace odemark {

/// State: positions of the bodies of mass 3, 4 and 5, then velocities. Each encounter multiplies errors.
template <class Real = double>
struct PythagoreanThreeBody {
  static constexpr std::string_view id = "pythagorean_three_body";
  static constexpr std::string_view title = "Pythagorean three-body problem";
  static constexpr std::string_view equations =
      "ri'' = sum over j of G mj (rj - ri)/|rj - ri|^3;  m = 3, 4, 5;  r(0) = (1, 3), (-2, -1), (1, -1);  "
      "r'(0) = 0";
  static constexpr std::string_view source =
      "C. Burrau, Astron. Nachr. 195 (1913) 113-118, doi:10.1002/asna.19131950602; V. Szebehely, C. F. "
      "Peters, "
      "Astron. J. 72 (1967) 876-883, doi:10.1086/110355";
  using Bodies = Gravity<3, 2>;
  static constexpr std::size_t size = Bodies::size;
  static constexpr std::array<Component, size> components{{{"x3", ""},
                                                           {"y3", ""},
                                                           {"x4", ""},
                                                           {"y4", ""},
                                                           {"x5", ""},
                                                           {"y5", ""},
                                                           {"vx3", ""},
                                                           {"vy3", ""},
                                                           {"vx4", ""},
                                                           {"vy4", ""},
                                                           {"vx5", ""},
                                                           {"vy5", ""}}};
  static constexpr std::array<std::string_view, 4> invariant_names{"energy", "momentum_x", "momentum_y",
                                                                   "angular_momentum"};
  static constexpr bool force_depends_on_velocity = false;

  Real G = 1, t_end = 3;

  static constexpr auto parameters() {
    using P = Parameter<PythagoreanThreeBody, Real>;
    return std::array{P{"G", "", "gravitational constant", &PythagoreanThreeBody::G, positive},
                      P{"t_end", "", "end of the interval", &PythagoreanThreeBody::t_end, positive}};
  }
  static constexpr std::array presets{
      Preset{"pythagorean_three_body", "", "past the first close encounter, at t = 1.88"},
      Preset{"pythagorean_three_body_t10", "t_end=10", "four encounters: errors grow a hundredfold at each"},
      Preset{"pythagorean_three_body_start", "t_end=1.5", "the fall: nothing close yet"}};

  std::array<double, size> scale() const {
    const double v = 2 * std::sqrt(double(G));
    return {2, 2, 2, 2, 2, 2, v, v, v, v, v, v};
  }
  double suggested_dt() const { return 0x1p-12 / std::sqrt(double(G)); }

  template <class T>
  void initial(T* y) const {
    constexpr std::array<int, size> start{1, 3, -2, -1, 1, -1};
    for (std::size_t i = 0; i < size; ++i) y[i] = T(start[i]);
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
    out[1] = Bodies::momentum(m, y, 0), out[2] = Bodies::momentum(m, y, 1);
    out[3] = Bodies::spin(m, y, 0, 1);
  }

 private:
  template <class T>
  std::array<T, 3> masses() const {
    return {3 * T(G), 4 * T(G), 5 * T(G)};
  }
};

}  // namespace odemark
