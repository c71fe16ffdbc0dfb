// Kinds of stability, strong stability, multistep methods and step control against published values.
#include <gtest/gtest.h>

#include "integrators/facts.hpp"
#include "integrators/facts_parts.hpp"
#include "tests/stability_cases.hpp"
#include "tests/tableaux.hpp"

namespace odemark::facts_kinds_test {
namespace {

using namespace tableaux;

constexpr Coefficient infinity = std::numeric_limits<Coefficient>::infinity();

MethodFacts facts_of(std::string_view id) {
  const AnyMethod& m = method(id);
  return method_facts(m.theory(), m.order, m.embedded_order);
}

// --- kinds of stability ---

TEST(FactsOfKinds, AnglesOfBdf) {
  // G. Akrivis, E. Katsoprinakis, BIT 60 (2020) 93-99
  const double known[] = {86.032366860211647, 73.351670474578482, 51.839755836049910, 17.839777792245700};
  for (int k = 3; k <= 6; ++k) {
    const auto facts = method_facts(bdf(k), k);
    EXPECT_FALSE(*facts.stability.a_stable);
    EXPECT_NEAR(double(*facts.stability.a_alpha_degrees), known[k - 3], 1e-9) << k;
    EXPECT_EQ(*facts.stability.r_infinity, 0);
    EXPECT_TRUE(*facts.zero_stable);
  }
  EXPECT_TRUE(*method_facts(bdf(2), 2).stability.l_stable);
}

TEST(FactsOfKinds, AnglesOfFunctionsAndOfLociAgree) {
  const auto theory = [](Coefficient c) {
    Theory t;
    t.numerator = {1, 1, c}, t.denominator = {1, 0, 0, -0.1L};
    return t;
  };
  const auto facts = detail::stability_facts(theory(0.3L));
  ASSERT_TRUE(facts.a_alpha_degrees);
  EXPECT_LT(*facts.a_alpha_degrees, 90);
  // just inside nothing is limited, just outside something is
  for (const Coefficient off : {-1e-6L, 1e-6L}) {
    const Coefficient a = (*facts.a_alpha_degrees + off) * std::acos(-1.0L) / 180;
    const bool unlimited =
        stability_limit(theory(0.3L), ray(-std::cos(a), std::sin(a))).verdict == Stability::unlimited;
    EXPECT_EQ(unlimited, off < 0);
  }
}

TEST(FactsOfKinds, PolesDecideToo) {
  // |R(iy)| <= 1 and |R(-x)| <= 1 everywhere, but poles at -3 +- i sqrt(3)
  auto q = RealPolynomial({1, 0.5L, 1 / 12.0L});
  for (int i = 0; i < 4; ++i) q = q * RealPolynomial({1, -1});
  Theory theory;
  theory.numerator = {1, -0.5L, 1 / 12.0L}, theory.denominator = q.value;
  const auto facts = detail::stability_facts(theory);
  EXPECT_EQ(*facts.imaginary_interval, infinity);
  EXPECT_EQ(*facts.real_interval, infinity);
  EXPECT_FALSE(*facts.a_stable);
  EXPECT_LT(*facts.a_alpha_degrees, 30);
}

TEST(FactsOfKinds, TrailingCoefficientsDoNotRuleAtInfinity) {
  Theory theory;
  theory.numerator = {1, 1e-17L}, theory.denominator = {1, -1};
  EXPECT_EQ(*detail::stability_facts(theory).r_infinity, 0);
  EXPECT_TRUE(*detail::stability_facts(theory).l_stable);
}

TEST(FactsOfKinds, KindsOfImplicitMethods) {
  const auto crouzeix = method_facts(crouzeix3(), 3), trapezoid = facts_of("implicit_trapezoid"),
             tr = method_facts(tr_bdf2(), 2, 3), sdirk43 = method_facts(hairer_wanner_sdirk43(), 4, 3),
             gauss = method_facts(gauss4(), 4), radau = method_facts(radau_iia3(), 3),
             alexander = facts_of("sdirk2"), ros = method_facts(ros2(), 2);
  EXPECT_NEAR(double(*crouzeix.stability.r_infinity), 1 - std::sqrt(3.0), 1e-15);
  EXPECT_TRUE(*crouzeix.algebraically_stable && *crouzeix.stability.a_stable);
  EXPECT_FALSE(*crouzeix.stability.l_stable);
  EXPECT_TRUE(*alexander.stability.l_stable && *alexander.stiffly_accurate);
  EXPECT_FALSE(*alexander.algebraically_stable);
  EXPECT_TRUE(*trapezoid.stability.a_stable && *trapezoid.stiffly_accurate && *trapezoid.symmetric);
  EXPECT_FALSE(*trapezoid.algebraically_stable || *trapezoid.stability.l_stable || *trapezoid.symplectic);
  EXPECT_NEAR(double(*trapezoid.stability.r_infinity), -1, 1e-15);
  EXPECT_TRUE(*tr.stability.l_stable && *tr.fsal);
  EXPECT_EQ(*tr.embedded.r_infinity, infinity);  // the estimate is less stable than what it estimates
  EXPECT_EQ(*tr.linear_solves_per_step, 2);
  EXPECT_TRUE(*sdirk43.stability.l_stable);
  EXPECT_NEAR(double(*sdirk43.embedded.r_infinity), 10 / 3.0, 1e-12);
  EXPECT_TRUE(*gauss.symplectic && *gauss.symmetric && *gauss.algebraically_stable);
  EXPECT_NEAR(double(*gauss.stability.r_infinity), 1, 1e-15);
  EXPECT_EQ(*gauss.stage_order, 2);
  EXPECT_TRUE(*radau.stability.l_stable && *radau.algebraically_stable && !*radau.symplectic);
  EXPECT_EQ(*radau.stage_order, 2);
  EXPECT_TRUE(*ros.stability.l_stable);
  EXPECT_EQ(*ros.order, 2);
}

TEST(FactsOfKinds, StrongStability) {
  const auto ralston = tableau({{}, {2 / 3.0L}}, {1 / 4.0L, 3 / 4.0L});
  const auto ssprk33 = tableau({{}, {1}, {0.25L, 0.25L}}, {1 / 6.0L, 1 / 6.0L, 2 / 3.0L});
  for (const auto& [facts, known] : {std::pair{facts_of("explicit_euler"), 1.0},
                                     {facts_of("heun"), 1.0},
                                     {method_facts(ralston, 2), 0.5},
                                     {method_facts(ssprk33, 3), 1.0},
                                     {method_facts(ssprk43(), 3), 2.0},
                                     {method_facts(ssprk104(), 4), 6.0},
                                     {facts_of("rk4"), 0.0},
                                     {facts_of("explicit_midpoint"), 0.0},
                                     {facts_of("implicit_midpoint"), 2.0},
                                     {facts_of("implicit_trapezoid"), 2.0},
                                     {facts_of("sdirk2"), 1 + std::sqrt(2.0)},
                                     {method_facts(tr_bdf2(), 2), 1 + std::sqrt(2.0)}})
    EXPECT_NEAR(double(*facts.ssp_coefficient), known, 1e-10);
  EXPECT_EQ(*facts_of("implicit_euler").ssp_coefficient, infinity);
}

TEST(FactsOfKinds, MultistepOnTheImaginaryAxis) {
  // next to 0 the principal root leaves the circle by y^3 and less: searches with a tolerance report 0.008
  // for order 2, 0.077 for order 6
  const auto adams = [](std::vector<Coefficient> b) {
    std::vector<Coefficient> rho(b.size() + 1, 0);
    rho[b.size()] = 1, rho[b.size() - 1] = -1;
    return multistep(rho, std::move(b));
  };
  const auto ab2 = method_facts(adams({-0.5L, 1.5L}), 2);
  EXPECT_EQ(*ab2.stability.imaginary_interval, 0);
  EXPECT_NEAR(double(ab2.stability.log_amplification->coefficient), 0.25, 1e-12);
  EXPECT_EQ(ab2.stability.log_amplification->power, 4);
  EXPECT_NEAR(double(*ab2.error_constant), 5 / 12.0, 1e-12);
  const auto ab6 = method_facts(adams({-475 / 1440.0L, 2877 / 1440.0L, -7298 / 1440.0L, 9982 / 1440.0L,
                                       -7923 / 1440.0L, 4277 / 1440.0L}),
                                6);
  EXPECT_EQ(*ab6.stability.imaginary_interval, 0);
  EXPECT_EQ(*ab6.order, 6);
  EXPECT_EQ(*ab6.step_ratio_limit, infinity);
}

TEST(FactsOfKinds, PredictorCorrectorsAtInfinity) {
  // with a new value on the left-hand side alone, a large z multiplies what is old
  EXPECT_EQ(*facts_of("adams_bashforth_moulton33").stability.r_infinity, infinity);
  // 1 + z^2 (w - 1/2): one root, and at infinity it is 1/2
  Theory theory;
  theory.characteristic = {{0, 1}, {0, 0}, {-0.5L, 1}};
  EXPECT_NEAR(double(*detail::stability_facts(theory).r_infinity), 0.5, 1e-15);
}

TEST(FactsOfKinds, RoundingsWithinStabilisedSteps) {
  // with the square of the number of stages, and never so far that they are worth half the digits
  for (const char* id : {"rkc1", "rkc2", "rkl2", "rock2", "rock4"}) {
    const auto facts = facts_of(id);
    ASSERT_TRUE(facts.internal_amplification) << id;
    EXPECT_LE(double(*facts.internal_amplification) * 0x1p-53, 10 * std::sqrt(0x1p-53)) << id;
    EXPECT_GT(double(*facts.internal_amplification), 1) << id;
  }
  EXPECT_EQ(*facts_of("rkc2").internal_amplification, 40'000);
}

TEST(FactsOfKinds, StepRatiosOfBdf) {
  for (const auto& [k, known] : {std::pair{2, 1 + std::sqrt(2.0)}, {3, (1 + std::sqrt(5.0)) / 2}})
    EXPECT_NEAR(double(*method_facts(bdf(k), k).step_ratio_limit), known, 1e-12) << k;
  EXPECT_NEAR(double(*method_facts(bdf(5), 5).step_ratio_limit), 1.127, 5e-4);
  EXPECT_EQ(*method_facts(bdf(1), 1).step_ratio_limit, infinity);
}

// --- step control ---

TEST(FactsOfKinds, ControllersOnTheBoundary) {
  // Bogacki and Shampine print two estimates. The first, of seven stages, is that of the published figures;
  // the second, which looks at the new state too and is the one of the method, shakes the step at the
  // boundary far more: at z* its error grows with |z| to the 20.6, that of the first to the 5.8.
  Theory first_estimate = method("bogacki_shampine54").theory();
  const Coefficient gap[] = {
      -3 / 1280.0L, 0, 6561 / 632320.0L, -343 / 20800.0L, 243 / 12800.0L, -1 / 95.0L, 0, 0};
  for (std::size_t i = 0; i < 8; ++i)
    first_estimate.tableau.b_embedded[i] = first_estimate.tableau.b[i] - gap[i];
  struct Row {
    MethodFacts facts;
    double elementary, pi, dopri;
  };
  for (const auto& row : {Row{facts_of("bogacki_shampine32"), 0.9075, 0.6567, 0.8200},
                          Row{facts_of("dormand_prince54"), 1.0223, 0.7240, 0.8905},
                          Row{facts_of("tsitouras54"), 1.0437, 0.7184, 0.9054},
                          Row{method_facts(fehlberg54(), 5, 4), 0.9849, 0.7478, 0.8716},
                          Row{method_facts(first_estimate, 5, 4), 1.1963, 0.7549, 1.0288},
                          Row{facts_of("bogacki_shampine54"), 2.6879, 2.1949, 2.4079},
                          Row{method_facts(cash_karp54(), 5, 4), 1.0889, 0.7216, 0.9419}}) {
    const auto& radii = *row.facts.controller_spectral_radius;
    EXPECT_NEAR(double(radii.at("elementary")), row.elementary, 5.1e-5);
    EXPECT_NEAR(double(radii.at("pi")), row.pi, 5.1e-5);
    EXPECT_NEAR(double(radii.at("dopri")), row.dopri, 5.1e-5);
  }
}

}  // namespace
}  // namespace odemark::facts_kinds_test
