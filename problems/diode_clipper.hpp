// The clipping stage of a guitar pedal: a resistor, a capacitor and two diodes that make it stiff when they
// conduct.
#pragma once
#include <algorithm>

#include "problems/family.hpp"

namespace odemark {

/// State x: output voltage. Where the diodes conduct the rate is 2 Is/(C Vt) cosh(x/Vt).
template <class Real = double>
struct DiodeClipper {
  static constexpr std::string_view id = "diode_clipper";
  static constexpr std::string_view title = "Diode clipper";
  static constexpr std::string_view equations = "x' = (A sin W t - x)/(R C) - 2 Is/C sinh(x/Vt)";
  static constexpr std::string_view source =
      "D. T. Yeh, J. S. Abel, A. Vladimirescu, J. O. Smith, Computer Music J. 32 (2008) 23-42, "
      "doi:10.1162/comj.2008.32.2.23";
  static constexpr std::size_t size = 1;
  static constexpr std::array<Component, size> components{{{"x", "V"}}};

  Real R = 2200, C = Real(1) / 100000000, Is = Real(252) / Real(100000000000.0), Vt = Real(453) / 10000,
       A = 2, W = 4096, t_end = Real(1) / 256;

  static constexpr auto parameters() {
    using P = Parameter<DiodeClipper, Real>;
    return std::array{P{"R", "ohm", "resistance", &DiodeClipper::R, positive},
                      P{"C", "F", "capacitance", &DiodeClipper::C, positive},
                      P{"Is", "A", "saturation current of a diode", &DiodeClipper::Is, positive},
                      P{"Vt", "V", "thermal voltage times ideality", &DiodeClipper::Vt, positive},
                      P{"A", "V", "amplitude of the input", &DiodeClipper::A},
                      P{"W", "rad/s", "rate of the input", &DiodeClipper::W, positive},
                      P{"t_end", "s", "end of the interval", &DiodeClipper::t_end, positive}};
  }
  static constexpr std::array presets{
      Preset{"diode_clipper", "", "650 Hz at 2 V: clips at half a volt"},
      Preset{"diode_clipper_quiet", "A=0.125", "too quiet to clip: a plain low-pass filter"},
      Preset{"diode_clipper_hot", "A=16,W=32768,t_end=1/2048",
             "5 kHz at 16 V: explicit methods fail at audio rates"}};

  std::array<double, size> scale() const { return {std::min(std::max(std::abs(double(A)), 1e-3), 1.0)}; }
  double suggested_dt() const {
    // what the diodes carry at most, over their voltage
    const double conducting = std::abs(double(A)) / double(R) / double(Vt) + 1 / double(R);
    return 0.125 * double(C) / conducting;
  }

  template <class T>
  void initial(T* y) const {
    y[0] = T(0);
  }
  template <class T>
  void rhs(const T& t, const T* y, T* dydt) const {
    using std::sin, std::sinh;
    dydt[0] = (T(A) * sin(T(W) * t) - y[0]) / (T(R) * T(C)) - 2 * T(Is) / T(C) * sinh(y[0] / T(Vt));
  }
  template <class T, class J>
  void jacobian(const T&, const T* y, J&& j) const {
    using std::cosh;
    j(0, 0) = -1 / (T(R) * T(C)) - 2 * T(Is) / T(C) / T(Vt) * cosh(y[0] / T(Vt));
  }
};

}  // namespace odemark
