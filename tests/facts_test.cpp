// Facts of coefficients against published values, and the traps that have fooled other suites.
#include "integrators/facts.hpp"

#include <gmock/gmock.h>

#include "integrators/fractions.hpp"
#include "integrators/tree_order.hpp"
#include "tests/stability_cases.hpp"
#include "tests/tableaux.hpp"

namespace odemark::facts_test {
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

TEST(Facts, TheIslandOfDop853) {
  const auto dop853 = facts_of("dop853");
  EXPECT_NEAR(double(*dop853.stability.real_interval), 6.3936515, 5e-7);
  ASSERT_EQ(dop853.stability.real_islands->size(), 1u);
  const auto& [low, high] = dop853.stability.real_islands->front();
  EXPECT_NEAR(double(low), 23.24915025, 5e-8);
  EXPECT_NEAR(double(high - low), 1.005e-5, 5e-9);  // a scan by hundredths never lands on it
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

TEST(Facts, WindowsOfPefrl) {
  const auto pefrl = facts_of("pefrl");
  EXPECT_NEAR(double(*pefrl.oscillator_limit), 2.98945, 5e-6);
  ASSERT_FALSE(pefrl.oscillator_windows->empty());
  EXPECT_NEAR(double(pefrl.oscillator_windows->front().first), 3.50542, 5e-6);
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

}  // namespace
}  // namespace odemark::facts_test
