// The slope is the fractional part of time: nothing but jumps to stumble over.
#pragma once
#include "problems/family.hpp"
#include "problems/unit_pieces.hpp"

namespace odemark {

template <class Real = double>
struct Sawtooth {
  static constexpr std::string_view id = "sawtooth";
  static constexpr std::string_view title = "Slope of a sawtooth";
  static constexpr std::string_view equations = "y' = t - floor(t)";
  static constexpr std::string_view source =
      "SUNDIALS, GitHub issue 722: a right-hand side that jumps at every second; y(10) = 5";
  static constexpr std::size_t size = 1;
  static constexpr std::array<Component, size> components{{{"y", ""}}};

  Real t_end = 10;
  UnitPieces pieces;

  static constexpr auto parameters() {
    using P = Parameter<Sawtooth, Real>;
    return std::array{P{"t_end", "s", "end of the interval", &Sawtooth::t_end,
                        Range{.lowest = 0, .highest = 1000, .open_below = true}}};
  }
  static constexpr std::array presets{
      Preset{"sawtooth", "", "ten teeth; each is a parabola, so the jumps are all"},
      Preset{"sawtooth_cut", "t_end=3.3125", "ends inside a tooth"}};

  std::array<double, size> scale() const { return {double(t_end) / 2}; }
  double suggested_dt() const { return 1.0 / 16; }
  std::vector<double> switch_times() const { return UnitPieces::switches_before(double(t_end)); }
  Sawtooth during(std::size_t phase) const {
    Sawtooth held = *this;
    held.pieces.held = int(phase);
    return held;
  }

  template <class T>
  void initial(T* y) const {
    y[0] = T(0);
  }
  template <class T>
  void rhs(const T& t, const T*, T* dydt) const {
    dydt[0] = t - T(pieces.at(t));
  }
  /// The exact flow: y0 is the state at t = 0.
  template <class T>
  void exact(const T& t, const T* y0, T* y) const {
    const T teeth = T(UnitPieces{}.at(t)), rest = t - teeth;
    y[0] = y0[0] + (teeth + rest * rest) / 2;
  }
};

}  // namespace odemark
