// Four diodes in a ring that multiply two signals: exponentials, fast oscillations and stiffness at once.
#pragma once
#include "problems/elliptic.hpp"
#include "problems/family.hpp"

namespace odemark {

/// State: voltages U1..U7, currents I1..I8. The capacity Cs, which the circuit does not really have, sets the
/// stiffness.
template <class Real = double>
struct RingModulator {
  static constexpr std::string_view id = "ring_modulator";
  static constexpr std::string_view title = "Ring modulator";
  static constexpr std::string_view equations =
      "C U1' = I1 - I3/2 + I4/2 + I7 - U1/R;  C U2' = I2 - I5/2 + I6/2 + I8 - U2/R;  Cs U3' = I3 - q1 + q4;  "
      "Cs U4' = q2 - "
      "q3 - I4;  Cs U5' = I5 + q1 - q3;  Cs U6' = q4 - q2 - I6;  Cp U7' = q1 + q2 - q3 - q4 - U7/Rp;  Lh I1' "
      "= -U1;  Lh "
      "I2' = -U2;  Ls2 I3' = U1/2 - U3 - Rg2 I3;  Ls3 I4' = U4 - U1/2 - Rg3 I4;  Ls2 I5' = U2/2 - U5 - Rg2 "
      "I5;  Ls3 I6' "
      "= U6 - U2/2 - Rg3 I6;  Ls1 I7' = Uin1 - U1 - (Ri + Rg1) I7;  Ls1 I8' = -U2 - (Rc + Rg1) I8;  q = "
      "gamma (exp(delta "
      "U) - 1) of U3 - U5 - U7 - Uin2, U6 - U4 - U7 - Uin2, U4 + U5 + U7 + Uin2, U7 - U3 - U6 + Uin2;  Uin1 "
      "= sin(2000 "
      "pi t)/2, Uin2 = 2 sin(20000 pi t)";
  static constexpr std::string_view source =
      "E. H. Horneber, Analyse nichtlinearer RLCU-Netzwerke (Kaiserslautern, 1976); F. Mazzia, C. Magherini, "
      "Test Set for "
      "Initial Value Problem Solvers, release 2.4 (2008), problem ringmod";
  static constexpr std::size_t size = 15;
  static constexpr std::array<Component, size> components{{{"U1", "V"},
                                                           {"U2", "V"},
                                                           {"U3", "V"},
                                                           {"U4", "V"},
                                                           {"U5", "V"},
                                                           {"U6", "V"},
                                                           {"U7", "V"},
                                                           {"I1", "A"},
                                                           {"I2", "A"},
                                                           {"I3", "A"},
                                                           {"I4", "A"},
                                                           {"I5", "A"},
                                                           {"I6", "A"},
                                                           {"I7", "A"},
                                                           {"I8", "A"}}};

  Real Cs = Real(1) / 1000000000, carrier = 2, signal = Real(1) / 2, t_end = Real(1) / 8192;

  static constexpr auto parameters() {
    using P = Parameter<RingModulator, Real>;
    return std::array{P{"Cs", "F", "parasitic capacity of the diodes", &RingModulator::Cs, positive},
                      P{"carrier", "V", "amplitude of the 10 kHz input", &RingModulator::carrier},
                      P{"signal", "V", "amplitude of the 1 kHz input", &RingModulator::signal},
                      P{"t_end", "s", "end of the interval", &RingModulator::t_end, positive}};
  }
  static constexpr std::array presets{
      Preset{"ring_modulator", "Cs=1e-9", "one period of the carrier, with a large parasitic capacity"},
      Preset{"ring_modulator_fast", "Cs=2e-12,t_end=3.814697265625e-06",
             "as published but for the end: oscillations of five gigaradians per second"}};

  std::array<double, size> scale() const {
    return {1, 1, 1, 1, 1, 1, 1, 1e-3, 1e-3, 1e-2, 1e-2, 1e-2, 1e-2, 1e-2, 1e-2};
  }
  double suggested_dt() const { return 1e-8 * std::sqrt(double(Cs) / 1e-9); }

  template <class T>
  void initial(T* y) const {
    for (std::size_t i = 0; i < size; ++i) y[i] = T(0);
  }
  template <class T>
  void rhs(const T& t, const T* y, T* dydt) const {
    using std::sin;
    const T turn = T(Real(2000) * elliptic::pi<Real>());
    const T in1 = T(signal) * sin(turn * t), in2 = T(carrier) * sin(T(10) * turn * t);
    const T q1 = diode<T>(y[2] - y[4] - y[6] - in2), q2 = diode<T>(y[5] - y[3] - y[6] - in2);
    const T q3 = diode<T>(y[3] + y[4] + y[6] + in2), q4 = diode<T>(y[6] - y[2] - y[5] + in2);
    const T C = of<T>(16, 1000000000), Cp = of<T>(1, 100000000), Lh = of<T>(445, 100), Ls1 = of<T>(2, 1000);
    const T Ls2 = of<T>(5, 10000), Rg1 = of<T>(363, 10), Rg2 = of<T>(173, 10);
    dydt[0] = (y[7] - y[9] / 2 + y[10] / 2 + y[13] - y[0] / 25000) / C;
    dydt[1] = (y[8] - y[11] / 2 + y[12] / 2 + y[14] - y[1] / 25000) / C;
    dydt[2] = (y[9] - q1 + q4) / T(Cs);
    dydt[3] = (q2 - q3 - y[10]) / T(Cs);
    dydt[4] = (y[11] + q1 - q3) / T(Cs);
    dydt[5] = (q4 - q2 - y[12]) / T(Cs);
    dydt[6] = (q1 + q2 - q3 - q4 - y[6] / 50) / Cp;
    dydt[7] = -(y[0] / Lh);
    dydt[8] = -(y[1] / Lh);
    dydt[9] = (y[0] / 2 - y[2] - Rg2 * y[9]) / Ls2;
    dydt[10] = (y[3] - y[0] / 2 - Rg2 * y[10]) / Ls2;
    dydt[11] = (y[1] / 2 - y[4] - Rg2 * y[11]) / Ls2;
    dydt[12] = (y[5] - y[1] / 2 - Rg2 * y[12]) / Ls2;
    dydt[13] = (in1 - y[0] - (50 + Rg1) * y[13]) / Ls1;
    dydt[14] = -((y[1] + (600 + Rg1) * y[14]) / Ls1);
  }

 private:
  template <class T>
  static T diode(const T& voltage) {
    using std::exp;
    const T gamma = T(Real(4067286402LL) / Real(100000000000000000LL)),
            delta = T(Real(177493332) / Real(10000000));
    return gamma * (exp(delta * voltage) - 1);
  }
  /// Published with a few decimals; rounded where the parameters are.
  template <class T>
  static T of(int numerator, int denominator) {
    return T(Real(numerator) / Real(denominator));
  }
};

}  // namespace odemark
