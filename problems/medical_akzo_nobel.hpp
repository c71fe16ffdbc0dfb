// Antibodies that enter a tissue and bind there: reaction and diffusion, with a supply that is switched off.
#pragma once
#include "problems/numbered.hpp"

namespace odemark {

/// State: (u1, v1, u2, v2, ...), free and bound substance at 20 places of a half line mapped to (0, 1].
template <class Real = double>
struct MedicalAkzoNobel {
  static constexpr std::string_view id = "medical_akzo_nobel";
  static constexpr std::string_view title = "Medical Akzo Nobel problem, 20 places";
  static constexpr std::string_view equations =
      "ui' = alphai (u(i+1) - u(i-1))/(2 dz) + betai (u(i-1) - 2 ui + u(i+1))/dz^2 - k ui vi;  vi' = -k ui "
      "vi,  alpha = 2 "
      "(z - 1)^3/c^2, beta = (z - 1)^4/c^2, zi = i dz, dz = 1/20, u0 = 2 for t < t_off, then 0;  ui(0) = 0, "
      "vi(0) = 1";
  static constexpr std::string_view source =
      "F. Mazzia, C. Magherini, Test Set for Initial Value Problem Solvers, release 2.4 (2008), problem "
      "medakzo "
      "(there with 200 places)";
  static constexpr std::size_t places = 20, size = 2 * places;
  static constexpr std::array<Component, size> components = [] {
    const auto u = numbered<"u", places>(""), v = numbered<"v", places>("");
    std::array<Component, size> all{};
    for (std::size_t i = 0; i < places; ++i) all[2 * i] = u[i], all[2 * i + 1] = v[i];
    return all;
  }();

  Real k = 100, c = 4, supply = 2, t_off = 5, t_end = 20;

  static constexpr auto parameters() {
    using P = Parameter<MedicalAkzoNobel, Real>;
    return std::array{
        P{"k", "", "rate at which free substance binds", &MedicalAkzoNobel::k, not_negative},
        P{"c", "", "scale of the map from the half line", &MedicalAkzoNobel::c, positive},
        P{"supply", "", "concentration at the surface while supplied", &MedicalAkzoNobel::supply},
        P{"t_off", "", "the instant the supply ends", &MedicalAkzoNobel::t_off, not_negative},
        P{"t_end", "", "end of the interval", &MedicalAkzoNobel::t_end, positive}};
  }
  static constexpr std::array presets{
      Preset{"medical_akzo_nobel", "t_off=1,t_end=2",
             "supplied until t = 1, then not: the boundary jumps (published: 5 and 20)"},
      Preset{"medical_akzo_nobel_supplied", "t_end=4", "before the jump: smooth"}};

  std::array<double, size> scale() const {
    std::array<double, size> out{};
    out.fill(1);
    return out;
  }
  double suggested_dt() const { return 0x1p-12; }

  /// The instants at which the right-hand side jumps; those outside the interval are of no concern.
  std::array<double, 1> switch_times() const { return {double(t_off)}; }
  /// The smooth problem of phase n: before the first switch (0), after it (1).
  MedicalAkzoNobel during(std::size_t phase) const {
    MedicalAkzoNobel held = *this;
    held.t_off =
        phase == 0 ? std::numeric_limits<Real>::infinity() : Real(-std::numeric_limits<Real>::infinity());
    return held;
  }

  template <class T>
  void initial(T* y) const {
    for (std::size_t i = 0; i < size; ++i) y[i] = T(i % 2 == 0 ? 0 : 1);
  }
  template <class T>
  void rhs(const T& t, const T* y, T* dydt) const {
    const T surface = step_at(t, t_off, supply, Real(0));
    for (std::size_t i = 0; i < places; ++i) {
      const T &u = y[2 * i], bound = T(k) * (u * y[2 * i + 1]);
      dydt[2 * i] = -bound, dydt[2 * i + 1] = -bound;
      if (i + 1 == places) continue;  // beta and alpha vanish there
      const T &before = i == 0 ? surface : y[2 * i - 2], &after = y[2 * i + 2];
      dydt[2 * i] = drift<T>(i) * (after - before) + spread<T>(i) * (before - 2 * u + after) - bound;
    }
  }
  template <class T, class J>
  void jacobian(const T&, const T* y, J&& j) const {
    for (std::size_t row = 0; row < size; ++row)
      for (std::size_t column = 0; column < size; ++column) j(row, column) = T(0);
    for (std::size_t i = 0; i < places; ++i) {
      const std::size_t u = 2 * i, v = u + 1;
      const T by_u = T(k) * y[v], by_v = T(k) * y[u];
      j(u, u) = -by_u, j(u, v) = -by_v, j(v, u) = -by_u, j(v, v) = -by_v;
      if (i + 1 == places) continue;
      j(u, u) = -by_u - 2 * spread<T>(i), j(u, u + 2) = spread<T>(i) + drift<T>(i);
      if (i > 0) j(u, u - 2) = spread<T>(i) - drift<T>(i);
    }
  }

 private:
  /// (z - 1)^3 = -(places - 1 - i)^3 dz^3 at place i, counted from 0.
  template <class T>
  T drift(std::size_t i) const {
    const int rest = int(places - 1 - i);
    return -(T(rest * rest * rest) / (T(int(places * places)) * T(c) * T(c)));
  }
  template <class T>
  T spread(std::size_t i) const {
    const int rest = int(places - 1 - i);
    return T(rest * rest * rest * rest) / (T(int(places * places)) * T(c) * T(c));
  }
};

}  // namespace odemark
