// A charge in uniform electric and magnetic fields: it gyrates and drifts across both.
#pragma once
#include <algorithm>

#include "problems/family.hpp"

namespace odemark {

/// State (x, v). B along z; E in the plane (x, z). The magnetic force does no work and turns at w = qB/m.
template <class Real = double>
struct ChargedParticle {
  static constexpr std::string_view id = "charged_particle";
  static constexpr std::string_view title = "Charge in crossed fields";
  static constexpr std::string_view equations =
      "x' = v;  m v' = q (E + v x B),  B = (0, 0, B), E = (Ex, 0, Ez)";
  static constexpr std::string_view source =
      "F. F. Chen, Introduction to Plasma Physics and Controlled Fusion, 3rd ed. (Springer, 2016), 2.2; J. "
      "P. Boris, "
      "Proc. 4th Conf. Numerical Simulation of Plasmas (1970) 3-67";
  static constexpr std::size_t size = 6;
  static constexpr std::array<Component, size> components{
      {{"x", "m"}, {"y", "m"}, {"z", "m"}, {"vx", "m/s"}, {"vy", "m/s"}, {"vz", "m/s"}}};
  static constexpr std::array<std::string_view, 3> invariant_names{"energy", "gyration_energy", "momentum_y"};
  static constexpr bool force_depends_on_velocity = true;

  Real q = 1, m = 1, B = 1, Ex = Real(1) / 16, Ez = 0, vx0 = 0, vy0 = 1, vz0 = Real(1) / 8, t_end = 60;

  static constexpr auto parameters() {
    using P = Parameter<ChargedParticle, Real>;
    return std::array{P{"q", "C", "charge", &ChargedParticle::q},
                      P{"m", "kg", "mass", &ChargedParticle::m, positive},
                      P{"B", "T", "magnetic field along z", &ChargedParticle::B, positive},
                      P{"Ex", "V/m", "electric field across", &ChargedParticle::Ex},
                      P{"Ez", "V/m", "electric field along B", &ChargedParticle::Ez},
                      P{"vx0", "m/s", "initial speed along x", &ChargedParticle::vx0},
                      P{"vy0", "m/s", "initial speed along y", &ChargedParticle::vy0},
                      P{"vz0", "m/s", "initial speed along z", &ChargedParticle::vz0},
                      P{"t_end", "s", "end of the interval", &ChargedParticle::t_end, positive}};
  }
  std::string validate() const { return q == 0 ? "q=0 feels no field" : ""; }
  static constexpr std::array presets{
      Preset{"charged_particle", "", "ten turns, drifting along -y at Ex/B"},
      Preset{"charged_particle_cycloid", "Ex=1,vy0=0,vz0=0", "from rest: a cycloid with cusps"},
      Preset{"charged_particle_long", "t_end=1500", "240 turns: phase and drift are what is left to lose"}};

  std::array<double, size> scale() const {
    const double v = std::max(std::hypot(double(vx0), double(vy0), double(vz0)),
                              std::hypot(double(Ex), double(Ez)) / double(B));
    const double radius = v * double(m) / (std::abs(double(q)) * double(B));
    const double drift = std::abs(double(Ex)) / double(B) * double(t_end);
    const double along = std::abs(double(vz0)) * double(t_end);
    return {radius, radius + drift, radius + along, v, v, v};
  }
  double suggested_dt() const { return 0.0625 * double(m) / (std::abs(double(q)) * double(B)); }

  template <class T>
  void initial(T* y) const {
    y[0] = T(0), y[1] = T(0), y[2] = T(0);
    y[3] = T(vx0), y[4] = T(vy0), y[5] = T(vz0);
  }
  template <class T>
  void acceleration(const T&, const T* y, T* a) const {
    const T per_mass = T(q) / T(m);
    a[0] = per_mass * (T(Ex) + T(B) * y[4]);
    a[1] = -per_mass * T(B) * y[3];
    a[2] = per_mass * T(Ez);
  }
  template <class T>
  void rhs(const T& t, const T* y, T* dydt) const {
    dydt[0] = y[3], dydt[1] = y[4], dydt[2] = y[5];
    acceleration(t, y, &dydt[3]);
  }
  template <class T, class J>
  void jacobian(const T&, const T*, J&& j) const {
    linear_part<T>(j);
  }
  template <class T, class L>
  void linear_part(L&& l) const {
    for (std::size_t row = 0; row < size; ++row)
      for (std::size_t column = 0; column < size; ++column) l(row, column) = column == row + 3 ? T(1) : T(0);
    const T w = T(q) / T(m) * T(B);
    l(3, 4) = w, l(4, 3) = -w;
  }

  /// The exact flow: y0 is the state at t = 0. About the drift Ex/B along -y the velocity turns clockwise.
  template <class T>
  void exact(const T& t, const T* y0, T* y) const {
    using std::cos, std::sin;
    const T w = T(q) / T(m) * T(B), drift = -T(Ex) / T(B), pull = T(q) / T(m) * T(Ez);
    const T vx = y0[3], vy = y0[4] - drift, vz = y0[5], half = sin(w * t / 2), s = sin(w * t), c = cos(w * t);
    y[0] = y0[0] + (vx * s + vy * 2 * half * half) / w;
    y[1] = y0[1] + drift * t + (vy * s - vx * 2 * half * half) / w;
    y[2] = y0[2] + vz * t + pull * t * t / 2;
    y[3] = vx * c + vy * s;
    y[4] = drift + vy * c - vx * s;
    y[5] = vz + pull * t;
  }
  /// Energy; energy of the gyration, as seen by who drifts along; canonical momentum along y.
  template <class T>
  void invariants(const T* y, T* out) const {
    const T drift = -T(Ex) / T(B), vy = y[4] - drift;
    out[0] = T(m) / 2 * (y[3] * y[3] + y[4] * y[4] + y[5] * y[5]) - T(q) * (T(Ex) * y[0] + T(Ez) * y[2]);
    out[1] = T(m) / 2 * (y[3] * y[3] + vy * vy);
    out[2] = T(m) * y[4] + T(q) * T(B) * y[0];
  }
};

}  // namespace odemark
