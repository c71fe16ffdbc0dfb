// A light buoy dropped into still water: the force of a spring that is there only under water.
#pragma once
#include <algorithm>

#include "problems/family.hpp"
#include "problems/piecewise.hpp"

namespace odemark {

/// State (z, v): height of the keel above the water and its rate. A box of cross-section A and height H: the
/// buoyancy has a kink where the keel leaves the water and one where the deck goes under.
template <class Real = double>
struct HeaveBuoy {
  static constexpr std::string_view id = "heave_buoy";
  static constexpr std::string_view title = "Buoy in heave";
  static constexpr std::string_view equations = "z' = v;  v' = -g + rho A g/m min(max(-z, 0), H)";
  static constexpr std::string_view source =
      "ours; Archimedes's law for a box, as games and marine simulators apply it";
  static constexpr std::size_t size = 2;
  static constexpr std::array<Component, size> components{{{"z", "m"}, {"v", "m/s"}}};
  static constexpr std::array<std::string_view, 1> invariant_names{"energy"};
  static constexpr bool force_depends_on_velocity = false;

  Real m = 50, A = 1, H = 1, rho = 1000, g = Real(157) / 16, z0 = Real(5) / 8, v0 = 0, t_end = 5;

  static constexpr auto parameters() {
    using P = Parameter<HeaveBuoy, Real>;
    return std::array{P{"m", "kg", "mass", &HeaveBuoy::m, positive},
                      P{"A", "m^2", "cross-section", &HeaveBuoy::A, positive},
                      P{"H", "m", "height of the box", &HeaveBuoy::H, positive},
                      P{"rho", "kg/m^3", "density of the water", &HeaveBuoy::rho, positive},
                      P{"g", "m/s^2", "gravity", &HeaveBuoy::g, positive},
                      P{"z0", "m", "initial height of the keel above the water", &HeaveBuoy::z0},
                      P{"v0", "m/s", "initial speed upwards", &HeaveBuoy::v0},
                      P{"t_end", "s", "end of the interval", &HeaveBuoy::t_end, positive}};
  }
  static constexpr std::array presets{
      Preset{"heave_buoy", "", "leaves the water again and again; explicit Euler throws it into the sky"},
      Preset{"heave_buoy_floating", "z0=-1/32",
             "small heave about the draught of 5 cm: a plain spring, 14 rad/s"},
      Preset{"heave_buoy_plunging", "m=512,z0=8,t_end=12",
             "dives under with its deck, comes back and leaps"}};

  std::array<double, size> scale() const {
    const double height = std::max(std::abs(double(z0)), double(m) / double(rho) / double(A));
    return {height, std::max(std::sqrt(2 * double(g) * height), std::abs(double(v0)))};
  }
  double suggested_dt() const {
    return 0.0625 * std::sqrt(double(m) / (double(rho) * double(A) * double(g)));
  }

  template <class T>
  void initial(T* y) const {
    y[0] = T(z0), y[1] = T(v0);
  }
  template <class T>
  void acceleration(const T&, const T* y, T* a) const {
    a[0] = T(rho) * T(A) * T(g) / T(m) * clamped(T(-y[0]), T(H)) - T(g);
  }
  template <class T>
  void rhs(const T& t, const T* y, T* dydt) const {
    dydt[0] = y[1];
    acceleration(t, y, &dydt[1]);
  }
  template <class T>
  void invariants(const T* y, T* out) const {
    const T keel = positive_part(T(-y[0])), deck = positive_part(T(-y[0] - T(H)));
    out[0] = T(m) * (y[1] * y[1] / 2 + T(g) * y[0]) + T(rho) * T(A) * T(g) * (keel * keel - deck * deck) / 2;
  }
};

}  // namespace odemark
