// Three equal masses that chase one another along an eight.
#pragma once
#include "problems/family.hpp"
#include "problems/gravity.hpp"

namespace odemark {

/// State: positions of the three, then velocities. Body 3 starts at the centre, 1 and 2 opposite each other.
template <class Real = double>
struct FigureEight {
  static constexpr std::string_view id = "figure_eight";
  static constexpr std::string_view title = "Figure-eight orbit of three bodies";
  static constexpr std::string_view equations =
      "ri'' = sum over j of m (rj - ri)/|rj - ri|^3;  r1(0) = -r2(0) = (x1, y1), r3(0) = 0;  r3'(0) = (vx3, "
      "vy3), r1'(0) = r2'(0) = -r3'(0)/2";
  static constexpr std::string_view source =
      "A. Chenciner, R. Montgomery, Ann. Math. 152 (2000) 881-901, doi:10.2307/2661357, with the start "
      "computed by C. Simo";
  using Bodies = Gravity<3, 2>;
  static constexpr std::size_t size = Bodies::size;
  static constexpr std::array<Component, size> components{{{"x1", ""},
                                                           {"y1", ""},
                                                           {"x2", ""},
                                                           {"y2", ""},
                                                           {"x3", ""},
                                                           {"y3", ""},
                                                           {"vx1", ""},
                                                           {"vy1", ""},
                                                           {"vx2", ""},
                                                           {"vy2", ""},
                                                           {"vx3", ""},
                                                           {"vy3", ""}}};
  static constexpr std::array<std::string_view, 4> invariant_names{"energy", "momentum_x", "momentum_y",
                                                                   "angular_momentum"};
  static constexpr bool force_depends_on_velocity = false;

  Real mass = 1, x1 = Real(97000436) / 100000000, y1 = Real(-24308753) / 100000000,
       vx3 = Real(-93240737) / 100000000, vy3 = Real(-86473146) / 100000000,
       t_end = Real(632591398) / 100000000;

  static constexpr auto parameters() {
    using P = Parameter<FigureEight, Real>;
    return std::array{
        P{"mass", "", "mass of each, times the gravitational constant", &FigureEight::mass, positive},
        P{"x1", "", "initial x of body 1", &FigureEight::x1},
        P{"y1", "", "initial y of body 1", &FigureEight::y1},
        P{"vx3", "", "initial vx of body 3", &FigureEight::vx3},
        P{"vy3", "", "initial vy of body 3", &FigureEight::vy3},
        P{"t_end", "", "end of the interval", &FigureEight::t_end, positive}};
  }
  static constexpr std::array presets{
      Preset{"figure_eight", "",
             "one period, 6.32591398: the end is the start up to the rounding of the data"},
      Preset{"figure_eight_third", "t_end=2.125",
             "a third of the way, where the bodies have changed places"}};

  std::array<double, size> scale() const {
    std::array<double, size> one;
    one.fill(1);
    return one;
  }
  double suggested_dt() const { return 0.015625; }

  template <class T>
  void initial(T* y) const {
    const T x(x1), z(y1), u(vx3), w(vy3);
    y[0] = x, y[1] = z, y[2] = -x, y[3] = -z, y[4] = T(0), y[5] = T(0);
    y[6] = y[8] = -(u / 2), y[7] = y[9] = -(w / 2), y[10] = u, y[11] = w;
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
    return {T(mass), T(mass), T(mass)};
  }
};

}  // namespace odemark
