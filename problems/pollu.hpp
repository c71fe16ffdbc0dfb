// Air pollution: twenty-five reactions among twenty species, rates over fifteen decades.
#pragma once
#include "problems/family.hpp"

namespace odemark {

/// State: concentrations, named by species.
template <class Real = double>
struct Pollu {
  static constexpr std::string_view id = "pollu";
  static constexpr std::string_view title = "Pollution, 20 species";
  static constexpr std::string_view equations =
      "y' = N r(y): 25 reactions of first and second order, r1 = 0.35 NO2 ... r19 = 4.44e11 O1D ... r25 = "
      "3.12 N2O5; "
      "NO = 0.2, O3 = 0.04, HCHO = 0.1, CO = 0.3, ALD = 0.01, SO2 = 0.007 at the start, the others 0";
  static constexpr std::string_view source =
      "J. G. Verwer, SIAM J. Sci. Comput. 15 (1994) 1243-1250, doi:10.1137/0915076; F. Mazzia, C. Magherini, "
      "Test Set for Initial Value Problem Solvers, release 2.4 (2008), problem pollu";
  static constexpr std::size_t size = 20;
  static constexpr std::array<Component, size> components{
      {{"NO2", ""},  {"NO", ""},  {"O3P", ""},  {"O3", ""},   {"HO2", ""}, {"OH", ""},  {"HCHO", ""},
       {"CO", ""},   {"ALD", ""}, {"MEO2", ""}, {"C2O3", ""}, {"CO2", ""}, {"PAN", ""}, {"CH3O", ""},
       {"HNO3", ""}, {"O1D", ""}, {"SO2", ""},  {"SO4", ""},  {"NO3", ""}, {"N2O5", ""}}};
  static constexpr std::array<std::string_view, 2> invariant_names{"nitrogen", "sulphur"};

  Real k1 = Real(35) / 100, t_end = 60;

  static constexpr auto parameters() {
    using P = Parameter<Pollu, Real>;
    return std::array{P{"k1", "1/min", "photolysis of NO2: how bright the day is", &Pollu::k1, not_negative},
                      P{"t_end", "min", "end of the interval", &Pollu::t_end, positive}};
  }
  static constexpr std::array presets{Preset{"pollu", "k1=0.35", "an hour, as published"},
                                      Preset{"pollu_t1", "k1=0.35,t_end=1", "the transients alone"}};

  /// Sizes within the hour; the smallest is what the fastest reaction leaves of O1D.
  std::array<double, size> scale() const {
    return {0.1,  0.2,  5e-9, 0.04, 1e-6, 1e-6,  0.1,   0.3,  0.01, 1e-7,
            1e-7, 1e-2, 1e-3, 1e-4, 0.01, 1e-17, 0.007, 1e-3, 1e-5, 1e-4};
  }
  /// O1D goes at the rate 4.4e11.
  double suggested_dt() const { return 2e-12; }

  template <class T>
  void initial(T* y) const {
    for (std::size_t i = 0; i < size; ++i) y[i] = T(0);
    y[1] = of<T>(2, 10), y[3] = of<T>(4, 100), y[6] = of<T>(1, 10);
    y[7] = of<T>(3, 10), y[8] = of<T>(1, 100), y[16] = of<T>(7, 1000);
  }
  template <class T>
  void rhs(const T&, const T* y, T* dydt) const {
    const T r1 = T(k1) * y[0], r2 = of<T>(266, 10) * (y[1] * y[3]), r3 = T(12300) * (y[4] * y[1]);
    const T r4 = of<T>(86, 100000) * y[6], r5 = of<T>(82, 100000) * y[6], r6 = T(15000) * (y[6] * y[5]);
    const T r7 = of<T>(13, 100000) * y[8], r8 = T(24000) * (y[8] * y[5]), r9 = T(16500) * (y[10] * y[1]);
    const T r10 = T(9000) * (y[10] * y[0]), r11 = of<T>(22, 1000) * y[12], r12 = T(12000) * (y[9] * y[1]);
    const T r13 = of<T>(188, 100) * y[13], r14 = T(16300) * (y[0] * y[5]), r15 = T(4800000) * y[2];
    const T r16 = of<T>(35, 100000) * y[3], r17 = of<T>(175, 10000) * y[3], r18 = T(100000000) * y[15];
    const T r19 = T(444e9) * y[15], r20 = T(1240) * (y[16] * y[5]), r21 = of<T>(21, 10) * y[18];
    const T r22 = of<T>(578, 100) * y[18], r23 = of<T>(474, 10000) * (y[0] * y[3]);
    const T r24 = T(1780) * (y[18] * y[0]), r25 = of<T>(312, 100) * y[19];
    dydt[0] = r2 + r3 + r9 + r11 + r12 + r22 + r25 - r1 - r10 - r14 - r23 - r24;
    dydt[1] = r1 + r21 - r2 - r3 - r9 - r12;
    dydt[2] = r1 + r17 + r19 + r22 - r15;
    dydt[3] = r15 - r2 - r16 - r17 - r23;
    dydt[4] = 2 * r4 + r6 + r7 + r13 + r20 - r3;
    dydt[5] = r3 + 2 * r18 - r6 - r8 - r14 - r20;
    dydt[6] = r13 - r4 - r5 - r6;
    dydt[7] = r4 + r5 + r6 + r7;
    dydt[8] = -r7 - r8;
    dydt[9] = r7 + r9 - r12;
    dydt[10] = r8 + r11 - r9 - r10;
    dydt[11] = r9;
    dydt[12] = r10 - r11;
    dydt[13] = r12 - r13;
    dydt[14] = r14;
    dydt[15] = r16 - r18 - r19;
    dydt[16] = -r20;
    dydt[17] = r20;
    dydt[18] = r23 + r25 - r21 - r22 - r24;
    dydt[19] = r24 - r25;
  }
  /// Atoms that no reaction makes or destroys.
  template <class T>
  void invariants(const T* y, T* out) const {
    out[0] = y[0] + y[1] + y[12] + y[14] + y[18] + 2 * y[19];
    out[1] = y[16] + y[17];
  }

 private:
  /// Published with a few decimals; rounded where the parameters are.
  template <class T>
  static T of(int numerator, int denominator) {
    return T(Real(numerator) / Real(denominator));
  }
};

}  // namespace odemark
