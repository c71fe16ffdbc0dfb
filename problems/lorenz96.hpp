// Weather round a circle of latitude: chaos in many components.
#pragma once
#include "problems/numbered.hpp"

namespace odemark {

/// State: a quantity at 40 places round the circle; starts at rest but for a nudge at place 20. Errors grow
/// by e^1.7 per unit of time, which stands for five days.
template <class Real = double>
struct Lorenz96 {
  static constexpr std::string_view id = "lorenz96";
  static constexpr std::string_view title = "Lorenz 96, 40 places";
  static constexpr std::string_view equations =
      "xi' = (x(i+1) - x(i-2)) x(i-1) - xi + F, i = 1..40 cyclic;  xi(0) = F, x20(0) = F + nudge";
  static constexpr std::string_view source =
      "E. N. Lorenz, in: Seminar on Predictability (ECMWF, 1996) 1-18; E. N. Lorenz, K. A. Emanuel, J. "
      "Atmos. Sci. "
      "55 (1998) 399-414, doi:10.1175/1520-0469(1998)055<0399:OSFSWO>2.0.CO;2";
  static constexpr std::size_t size = 40;
  static constexpr std::array<Component, size> components = numbered<"x", size>("");

  Real F = 8, nudge = Real(1) / 128, t_end = 2;

  static constexpr auto parameters() {
    using P = Parameter<Lorenz96, Real>;
    return std::array{P{"F", "", "forcing", &Lorenz96::F},
                      P{"nudge", "", "disturbance of the start", &Lorenz96::nudge},
                      P{"t_end", "", "end of the interval", &Lorenz96::t_end, positive}};
  }
  static constexpr std::array presets{
      Preset{"lorenz96", "", "the nudge grows into waves: ten days of weather"},
      Preset{"lorenz96_developed", "nudge=1,t_end=8",
             "turbulent all round; double precision keeps ten digits"}};

  std::array<double, size> scale() const {
    std::array<double, size> out{};
    out.fill(8);
    return out;
  }
  double suggested_dt() const { return 0.0078125; }

  template <class T>
  void initial(T* y) const {
    for (std::size_t i = 0; i < size; ++i) y[i] = T(F);
    y[size / 2 - 1] = T(F + nudge);
  }
  template <class T>
  void rhs(const T&, const T* y, T* dydt) const {
    for (std::size_t i = 0; i < size; ++i) {
      const T &next = y[(i + 1) % size], &last = y[(i + size - 1) % size],
              &earlier = y[(i + size - 2) % size];
      dydt[i] = (next - earlier) * last - y[i] + T(F);
    }
  }
  template <class T, class J>
  void jacobian(const T&, const T* y, J&& j) const {
    for (std::size_t row = 0; row < size; ++row) {
      for (std::size_t column = 0; column < size; ++column) j(row, column) = T(0);
      const std::size_t next = (row + 1) % size, last = (row + size - 1) % size,
                        earlier = (row + size - 2) % size;
      j(row, row) = T(-1), j(row, next) = y[last], j(row, earlier) = -y[last];
      j(row, last) = y[next] - y[earlier];
    }
  }
};

}  // namespace odemark
