// Facts of coefficients against published values, and the traps that have fooled other suites.
#include "integrators/facts.hpp"

#include <gmock/gmock.h>

#include "integrators/facts_parts.hpp"
#include "integrators/fractions.hpp"
#include "integrators/tree_order.hpp"
#include "tests/stability_cases.hpp"
#include "tests/tableaux.hpp"

namespace odemark {
namespace {

using namespace tableaux;

constexpr Coefficient infinity = std::numeric_limits<Coefficient>::infinity();

MethodFacts facts_of(std::string_view id) {
  const AnyMethod& m = method(id);
  return method_facts(m.theory(), m.order, m.embedded_order);
}

// --- orders ---

TEST(TreeOrders, TreesAreCounted) {
  const std::size_t known[] = {1, 1, 2, 4, 9, 20, 48, 115, 286, 719, 1842, 4766};
  for (int order = 1; order <= 12; ++order) EXPECT_EQ(count_trees(order), known[order - 1]) << order;
}

TEST(TreeOrders, FractionsAreFoundAgain) {
  for (const auto& [p, q] : {std::pair{19372L, 6561L},
                             {-25360L, 2187L},
                             {1L, 3L},
                             {0L, 1L},
                             {208L, 1L},
                             {29443841L, 614563906L}}) {
    const auto found = simplest_fraction(static_cast<Coefficient>(p) / static_cast<Coefficient>(q));
    ASSERT_TRUE(found) << p << "/" << q;
    EXPECT_EQ(found->numerator, p);
    EXPECT_EQ(found->denominator, q);
  }
  EXPECT_FALSE(simplest_fraction(std::sqrt(2.0L)));
  EXPECT_FALSE(simplest_fraction(std::acos(-1.0L)));
  EXPECT_FALSE(simplest_fraction(infinity));
}

TEST(TreeOrders, AreProvedInIntegersWhereCoefficientsAreFractions) {
  struct Case {
    Theory theory;
    int order, embedded;
  };
  for (const auto& c :
       {Case{fehlberg54(), 5, 4}, Case{cash_karp54(), 5, 4}, Case{hairer_wanner_sdirk43(), 4, 3},
        Case{radau_iia3(), 3, 0}, Case{ssprk104(), 4, 0}}) {
    const auto main = tree_order(c.theory.tableau, c.theory.tableau.b);
    EXPECT_EQ(main.order, c.order);
    EXPECT_TRUE(main.exact);
    if (c.embedded > 0) {
      EXPECT_EQ(tree_order(c.theory.tableau, c.theory.tableau.b_embedded).order, c.embedded);
    }
  }
  for (const auto& [theory, order] :
       {std::pair{crouzeix3(), 3}, {tr_bdf2(), 2}, {gauss4(), 4}, {ros2(), 2}}) {
    const auto found = tree_order(theory.tableau, theory.tableau.b);
    EXPECT_EQ(found.order, order);
    EXPECT_FALSE(found.exact);  // square roots
  }
}

TEST(TreeOrders, OneWrongDigitIsSeen) {
  Theory wrong = fehlberg54();
  wrong.tableau.a[5 * 6 + 3] = 1859 / 4105.0L;
  EXPECT_LT(tree_order(wrong.tableau, wrong.tableau.b).order, 5);
  // in the last of 21 digits it is below what rounding can tell, but not below what integers can
  Theory slightly = fehlberg54();
  slightly.tableau.b[0] = std::nextafter(slightly.tableau.b[0], 1.0L);
  const auto found = tree_order(slightly.tableau, slightly.tableau.b);
  EXPECT_EQ(found.order, 5);
  EXPECT_FALSE(found.exact);
}

TEST(TreeOrders, PrincipalErrorNorms) {
  EXPECT_NEAR(double(*facts_of("dormand_prince54").error_constant), 3.99e-4, 5e-7);
  EXPECT_NEAR(double(*facts_of("rk4").error_constant), 1.45e-2, 5e-6);
  EXPECT_NEAR(double(*facts_of("tsitouras54").embedded_error_constant), 1.065e-3, 5e-7);
}

TEST(TreeOrders, EveryMethodHasTheOrdersItClaims) {
  for (const auto& m : suite_methods()) {
    const auto facts = method_facts(m.theory(), m.order, m.embedded_order);
    ASSERT_TRUE(facts.order) << m.id;
    EXPECT_EQ(*facts.order, m.order) << m.id << ": " << facts.order.reason;
    if (m.embedded_order > 0) {
      ASSERT_TRUE(facts.embedded_order) << m.id;
      EXPECT_EQ(*facts.embedded_order, m.embedded_order) << m.id << ": " << facts.embedded_order.reason;
    }
    EXPECT_TRUE(!facts.zero_stable || *facts.zero_stable) << m.id;
  }
}

// --- intervals ---

TEST(Facts, IntervalsOfExactTables) {
  const auto rk4 = facts_of("rk4"), heun = facts_of("heun"), fehlberg = method_facts(fehlberg54(), 5, 4);
  EXPECT_NEAR(double(*rk4.stability.real_interval), 2.785293563405282, 1e-14);
  EXPECT_NEAR(double(*rk4.stability.imaginary_interval), std::sqrt(8.0), 1e-14);
  EXPECT_EQ(*heun.stability.imaginary_interval, 0);
  EXPECT_EQ(*fehlberg.stability.imaginary_interval, 0);  // strictly; but it gains less than 1e-3 a step ...
  EXPECT_NEAR(double(*fehlberg.stability.imaginary_interval_eps), 1.090, 5e-4);
  EXPECT_NEAR(double(fehlberg.damped_limit->at(0.01L)), 3.586,
              5e-4);  // ... and one percent of damping is enough
}

TEST(Facts, ATouchIsNotTheEnd) {
  // a + b T_10(1 + 3 z / 99), the undamped Chebyshev method of order 2: real interval 66
  const Coefficient s2 = 100, b = (s2 - 1) / (3 * s2);
  RealPolynomial before({1}), now({1, 3 / (s2 - 1)});
  for (int k = 1; k < 10; ++k) {
    const auto next = RealPolynomial({2, 6 / (s2 - 1)}) * now - before;
    before = now, now = next;
  }
  auto r = now * RealPolynomial({b});
  r.value[0] += 1 - b;
  const auto facts = method_facts(polynomial(r.value), 2);
  EXPECT_NEAR(double(*facts.stability.real_interval), 66, 1e-9);
  EXPECT_THAT(facts.stability.real_interval.reason, testing::HasSubstr("touches the boundary 4 times"));
}

TEST(Facts, IslandsNarrowerThanAScanAreListed) {
  // R = 1 + q with q = c x (x - 1)(x - 3)(x - 3 - 1e-5) on x = -z: stable where -2 <= q <= 0
  auto q = RealPolynomial({0, 1});
  for (const Coefficient root : {1.0L, 3.0L, 3.00001L}) q = q * RealPolynomial({root, 1});
  auto r = q * RealPolynomial({1 / 9.00003L});
  r.value[0] = 1;
  const auto facts = method_facts(polynomial(r.value), 1);
  EXPECT_NEAR(double(*facts.stability.real_interval), 1, 1e-12);
  ASSERT_EQ(facts.stability.real_islands->size(), 1u);
  EXPECT_NEAR(double(facts.stability.real_islands->front().first), 3, 1e-9);
  EXPECT_NEAR(double(facts.stability.real_islands->front().second), 3.00001, 1e-9);
}

TEST(Facts, WindowsOfSplittings) {
  const auto yoshida = facts_of("yoshida4");
  EXPECT_NEAR(double(*yoshida.oscillator_limit), 1.57340194743, 5e-12);
  // S. Blanes, P. C. Moan, J. Comput. Appl. Math. 142 (2002) 313-330, S6: a gap only 0.027 wide
  const Coefficient a[] = {0.0792036964311957L, 0.353172906049774L, -0.0420650803577195L},
                    b[] = {0.209515106613362L, -0.143851773179818L};
  const Coefficient a4 = 1 - 2 * (a[0] + a[1] + a[2]), b3 = 0.5L - b[0] - b[1];
  std::vector<SecondOrderMove> moves;
  const Coefficient drifts[] = {a[0], a[1], a[2], a4, a[2], a[1], a[0]},
                    kicks[] = {b[0], b[1], b3, b3, b[1], b[0]};
  for (std::size_t i = 0; i < 7; ++i) {
    moves.push_back({What::drift, drifts[i]});
    if (i < 6) moves.push_back({What::kick, kicks[i]});
  }
  const auto facts = method_facts(of_moves(moves), 4);
  EXPECT_NEAR(double(*facts.oscillator_limit), 3.13282, 5e-6);
  ASSERT_FALSE(facts.oscillator_windows->empty());
  EXPECT_NEAR(double(facts.oscillator_windows->front().first), 3.16011, 5e-6);
  EXPECT_NEAR(double(facts.oscillator_windows->front().second), 6.314, 5e-4);
  EXPECT_TRUE(*facts.symplectic);
  EXPECT_TRUE(*facts.symmetric);
}

TEST(Facts, DampedSprings) {
  struct Row {
    std::string_view id;
    double at[5];
  };
  for (const auto& row : {Row{"rk4", {2.848570, 2.950853, 2.622543, 2.785294, 0.746317}},
                          Row{"dormand_prince54", {1.872130, 2.681407, 3.398992, 3.306568, 0.885992}},
                          Row{"semi_implicit_euler", {1.980100, 1.809975, 1.236068, 0.828427, 0.472136}}}) {
    const auto limits = *facts_of(row.id).damped_limit;
    std::size_t i = 0;
    for (const auto& [zeta, limit] : limits) EXPECT_NEAR(double(limit), row.at[i++], 5.1e-7) << row.id;
    EXPECT_EQ(i, 5u);
  }
}

// --- growth and phase ---

TEST(Facts, AmplitudeAndPhaseOfSmallSteps) {
  struct Case {
    MethodFacts facts;
    double growth;
    int power;
    double phase;
    int phase_power;
  };
  for (const auto& c :
       {Case{facts_of("explicit_euler"), 1 / 2.0, 2, -1 / 3.0, 3},
        Case{facts_of("heun"), 1 / 8.0, 4, 1 / 6.0, 3}, Case{facts_of("rk4"), -1 / 144.0, 6, -1 / 120.0, 5},
        Case{facts_of("dormand_prince54"), -0.00055556 / 2, 6, 1 / 2100.0, 7},
        Case{facts_of("implicit_euler"), -1 / 2.0, 2, -1 / 3.0, 3},
        Case{method_facts(radau_iia3(), 3), -1 / 72.0, 4, -1 / 270.0, 5},
        Case{method_facts(bdf(2), 2), -1 / 4.0, 4, -1 / 3.0, 3},
        Case{facts_of("implicit_trapezoid"), 0, 0, -1 / 12.0, 3},
        Case{facts_of("semi_implicit_euler"), 0, 0, 1 / 24.0, 3},
        Case{facts_of("stormer_verlet"), 0, 0, 1 / 24.0, 3}}) {
    const auto& s = c.facts.stability;
    if (c.power == 0) {
      EXPECT_FALSE(s.log_amplification);
    } else {
      ASSERT_TRUE(s.log_amplification);
      EXPECT_EQ(s.log_amplification->power, c.power);
      EXPECT_NEAR(double(s.log_amplification->coefficient), c.growth, 1e-8);
    }
    ASSERT_TRUE(s.phase_error);
    EXPECT_EQ(s.phase_error->power, c.phase_power);
    EXPECT_NEAR(double(s.phase_error->coefficient), c.phase, 1e-6);
  }
}

TEST(Facts, TheSeriesIsThatOfTheFunction) {
  for (const auto& m : suite_methods()) {
    const auto facts = method_facts(m.theory(), m.order, m.embedded_order);
    const auto& law = facts.stability.log_amplification;
    if (!law || m.theory().numerator.empty() || law->power > 12) continue;
    const Coefficient y = 0.0625L, found = growth_per_step(m.theory(), imaginary_axis(), y);
    EXPECT_NEAR(double(found / (law->coefficient * std::pow(y, Coefficient(law->power)))), 1, 0.05) << m.id;
  }
}

// --- kinds of stability ---

TEST(Facts, AnglesOfBdf) {
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

TEST(Facts, AnglesOfFunctionsAndOfLociAgree) {
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

TEST(Facts, PolesDecideToo) {
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

TEST(Facts, TrailingCoefficientsDoNotRuleAtInfinity) {
  Theory theory;
  theory.numerator = {1, 1e-17L}, theory.denominator = {1, -1};
  EXPECT_EQ(*detail::stability_facts(theory).r_infinity, 0);
  EXPECT_TRUE(*detail::stability_facts(theory).l_stable);
}

TEST(Facts, KindsOfImplicitMethods) {
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

TEST(Facts, StrongStability) {
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

TEST(Facts, MultistepOnTheImaginaryAxis) {
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

TEST(Facts, StepRatiosOfBdf) {
  for (const auto& [k, known] : {std::pair{2, 1 + std::sqrt(2.0)}, {3, (1 + std::sqrt(5.0)) / 2}})
    EXPECT_NEAR(double(*method_facts(bdf(k), k).step_ratio_limit), known, 1e-12) << k;
  EXPECT_NEAR(double(*method_facts(bdf(5), 5).step_ratio_limit), 1.127, 5e-4);
  EXPECT_EQ(*method_facts(bdf(1), 1).step_ratio_limit, infinity);
}

// --- step control ---

TEST(Facts, ControllersOnTheBoundary) {
  struct Row {
    MethodFacts facts;
    double elementary, pi, dopri;
  };
  for (const auto& row : {Row{facts_of("bogacki_shampine32"), 0.9075, 0.6567, 0.8200},
                          Row{facts_of("dormand_prince54"), 1.0223, 0.7240, 0.8905},
                          Row{facts_of("tsitouras54"), 1.0437, 0.7184, 0.9054},
                          Row{method_facts(fehlberg54(), 5, 4), 0.9849, 0.7478, 0.8716},
                          Row{method_facts(cash_karp54(), 5, 4), 1.0889, 0.7216, 0.9419}}) {
    const auto& radii = *row.facts.controller_spectral_radius;
    EXPECT_NEAR(double(radii.at("elementary")), row.elementary, 5.1e-5);
    EXPECT_NEAR(double(radii.at("pi")), row.pi, 5.1e-5);
    EXPECT_NEAR(double(radii.at("dopri")), row.dopri, 5.1e-5);
  }
}

}  // namespace
}  // namespace odemark
