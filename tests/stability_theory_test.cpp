// Stability limits from coefficients: published values, and the traps where a naive search goes wrong.
#include <algorithm>
#include <limits>
#include <numbers>

#include "integrators/methods/explicit_euler.hpp"
#include "integrators/methods/heun.hpp"
#include "integrators/methods/rk4.hpp"
#include "integrators/methods/semi_implicit_euler.hpp"
#include "integrators/real_polynomial.hpp"
#include "tests/stability_cases.hpp"

namespace odemark::stability_theory_test {
namespace {

// --- polynomials ---

TEST(RealPolynomials, ATangencyIsNoBoundary) {
  const RealPolynomial double_root = RealPolynomial({-1, 1}) * RealPolynomial({-1, 1});
  const auto found = where_not_negative(double_root * RealPolynomial({3, -1}));
  ASSERT_EQ(found.where.size(), 1u);
  EXPECT_EQ(found.where[0].first, 0);
  EXPECT_NEAR(double(found.where[0].second), 3, 1e-15);
  ASSERT_EQ(found.touches.size(), 1u);
  EXPECT_NEAR(double(found.touches[0]), 1,
              1e-9);  // a double root is only known to the square root of a rounding
}

TEST(RealPolynomials, IslandsAreListed) {
  auto p = RealPolynomial({1, -1});  // (1 - x)(2 - x)(2.001 - x)(7 - x)(9 - x)
  for (const Coefficient root : {2.0L, 2.001L, 7.0L, 9.0L}) p = p * RealPolynomial({root, -1});
  const auto found = where_not_negative(p);
  ASSERT_EQ(found.where.size(), 3u);
  const double expected[3][2] = {{0, 1}, {2, 2.001}, {7, 9}};
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(double(found.where[i].first), expected[i][0], 1e-12);
    EXPECT_NEAR(double(found.where[i].second), expected[i][1], 1e-12);
  }
}

TEST(RealPolynomials, RoundingDoesNotDecideASign) {
  RealPolynomial p;
  p.add_term(2, 1 + 1e-17L), p.add_term(2, -1), p.add_term(4, 1);
  p.clean();
  EXPECT_EQ(p.value[2], 0);
  EXPECT_EQ(where_not_negative(p).where.front().second, std::numeric_limits<Coefficient>::infinity());
}

// --- theory: one-step methods ---

TEST(StabilityTheory, PublishedIntervals) {
  struct Case {
    const char* id;
    double real, imaginary;  // 0: none
  };
  for (const Case& c :
       {Case{"explicit_euler", 2, 0}, Case{"heun", 2, 0}, Case{"explicit_midpoint", 2, 0},
        Case{"bogacki_shampine32", 2.512745326618329, std::sqrt(3.0)},
        Case{"rk4", 2.785293563405282, 2 * std::sqrt(2.0)},
        Case{"rk38", 2.785293563405282, 2 * std::sqrt(2.0)},
        Case{"taylor4", 2.785293563405282, 2 * std::sqrt(2.0)}, Case{"step_doubling_euler", 4, 0},
        Case{"taylor5", 3.217048, 0}, Case{"adams_bashforth2", 1, 0},
        Case{"adams_bashforth3", 6.0 / 11, 12 / (5 * std::sqrt(11.0))}}) {
    EXPECT_NEAR(limit_of(c.id, real_axis()), c.real, c.real == 3.217048 ? 1e-6 : 1e-12) << c.id;
    if (c.imaginary > 0)
      EXPECT_NEAR(limit_of(c.id, imaginary_axis()), c.imaginary, 1e-12) << c.id;
    else
      EXPECT_EQ(verdict_of(c.id, imaginary_axis()), Stability::unstable) << c.id;
  }
  EXPECT_NEAR(limit_of("dormand_prince54", real_axis()), 3.306568, 1e-6);
  EXPECT_NEAR(limit_of("tsitouras54", real_axis()), 3.506847, 1e-6);
  EXPECT_NEAR(limit_of("tsitouras54", imaginary_axis()), 0.477979, 1e-6);
}

TEST(StabilityTheory, ImplicitMethodsHaveNoLimitInTheLeftHalfPlane) {
  for (const auto* id : {"implicit_euler",
                         "implicit_trapezoid",
                         "implicit_midpoint",
                         "sdirk2",
                         "sdirk3_alexander",
                         "sdirk3_crouzeix",
                         "sdirk43",
                         "tr_bdf2",
                         "esdirk32",
                         "esdirk43",
                         "esdirk54",
                         "kvaerno32",
                         "kvaerno43",
                         "kvaerno54",
                         "gauss4",
                         "gauss6",
                         "gauss8",
                         "radau_ia3",
                         "radau_ia5",
                         "radau_iia3",
                         "radau_iia5",
                         "radau_iia9",
                         "radau_iia13",
                         "lobatto_iiia4",
                         "lobatto_iiib4",
                         "lobatto_iiic4",
                         "exponential_euler"})
    for (int i = 0; i <= 24; ++i) {
      const Coefficient angle = Coefficient(i) / 48 * std::numbers::pi_v<Coefficient>;
      const auto p = i == 0    ? imaginary_axis()
                     : i == 24 ? real_axis()
                               : ray(-std::sin(angle), std::cos(angle));
      EXPECT_EQ(verdict_of(id, p), Stability::unlimited) << id << " at " << i;
    }
}

TEST(StabilityTheory, TheOrderOfAStabilityFunctionIsReadOffIt) {
  EXPECT_EQ(linear_order(method("rk4").theory()), 4);
  EXPECT_EQ(linear_order(method("tsitouras54").theory()), 5);
  EXPECT_EQ(linear_order(method("sdirk2").theory()), 2);
  EXPECT_EQ(linear_order(method("taylor20").theory()), 20);
}

TEST(StabilityTheory, DigitsOfCoefficientsDoNotDecideTheImaginaryAxis) {
  // typed with 12 digits, the powers that order makes vanish are 1e-13, of either sign
  for (const Coefficient slip : {1e-12L, -1e-12L}) {
    EXPECT_NEAR(limit_of(polynomial({1, 1, 0.5L + slip, 1 / 6.0L - slip, 1 / 24.0L}), imaginary_axis()),
                2 * std::sqrt(2.0), 1e-9);
    EXPECT_EQ(stability_limit(polynomial({1, 1, 0.5L + slip}), imaginary_axis()).verdict,
              Stability::unstable);
  }
}

TEST(StabilityTheory, UndampedChebyshevTouchesAndGoesOn) {
  // T_5(1 + z / 25) touches |R| = 1 four times inside its interval [0, 50]
  RealPolynomial before({1}), now({1, 1 / 25.0L});
  for (int k = 1; k < 5; ++k) {
    const auto next = RealPolynomial({2, 2 / 25.0L}) * now - before;
    before = now, now = next;
  }
  const auto found = stability_limit(polynomial(now.value), real_axis());
  ASSERT_EQ(found.verdict, Stability::limit);
  EXPECT_NEAR(double(found.limit), 50, 1e-10);
  ASSERT_EQ(found.touches.size(), 4u);
  for (int k = 1; k < 5; ++k)
    EXPECT_NEAR(double(found.touches[std::size_t(k - 1)]), 25 * (1 - std::cos(k * std::numbers::pi / 5)),
                1e-6);
}

TEST(StabilityTheory, AnIslandIsABandNotTheLimit) {
  // |R|^2 <= 1 on the real axis where (1 - z)... : R = 1 - r + c r^2 with a hump above 1 between two stable
  // stretches
  const auto found = stability_limit(polynomial({1, 1, 0.13L, 0.0045L}), real_axis());
  ASSERT_EQ(found.verdict, Stability::limit);
  ASSERT_EQ(found.later_bands.size(), 1u);
  const auto r = [](Coefficient x) { return std::abs(1 - x + 0.13L * x * x - 0.0045L * x * x * x); };
  EXPECT_NEAR(double(r(found.limit)), 1, 1e-12);
  EXPECT_GT(double(r((found.limit + found.later_bands[0].first) / 2)), 1);
  EXPECT_LT(double(r((found.later_bands[0].first + found.later_bands[0].second) / 2)), 1);
}

TEST(StabilityTheory, TheShipsPositionNeverLimits) {
  const auto ship = linear_problem(2, {0, 0, 1, -0.1L}, true);  // eigenvalues 0 and -0.1
  for (const auto* id : {"explicit_euler", "heun", "semi_implicit_euler"})
    EXPECT_NEAR(limit_of(id, ship), 20, 1e-12) << id;
  EXPECT_NEAR(limit_of("stormer_verlet", ship), 40, 1e-12);  // two kicks of half a step: (1 - z/2)^2
  EXPECT_NEAR(limit_of("rk4", ship), 27.85293563405282, 1e-10);
  EXPECT_NEAR(limit_of("adams_bashforth2", ship), 10, 1e-12);
  EXPECT_EQ(verdict_of("implicit_euler", ship), Stability::unlimited);
}

// --- theory: moves, and which update of table 3.5 each method is ---

TEST(StabilityTheory, MovesOnDampedSprings) {
  struct Row {
    std::string_view id;
    double at[5];  // zeta = 0.01, 0.1, 0.5, 1, 2
  };
  const Row rows[] = {
      {"explicit_euler", {0.02, 0.2, 1, 2, 0.535898}},
      {"heun", {0.444003, 1.049755, 2, 2, 0.535898}},
      {"explicit_midpoint", {0.444003, 1.049755, 2, 2, 0.535898}},
      {"bogacki_shampine32", {1.796488, 2.154049, 2.521659, 2.512745, 0.673288}},
      {"rk4", {2.848570, 2.950853, 2.622543, 2.785294, 0.746317}},
      {"dormand_prince54", {1.872130, 2.681407, 3.398992, 3.306568, 0.885992}},
      {"tsitouras54", {1.916567, 2.777940, 3.535998, 3.506847, 0.939657}},
      {"semi_implicit_euler", {1.980100, 1.809975, 1.236068, 0.828427, 0.472136}},
      {"chapter_euler", {1.980100, 1.809975, 1.236068, 0.828427, 0.472136}},
      {"velocity_verlet_old_velocity", {2, 2, 2, 1, 0.5}},
      {"velocity_verlet_predicted_velocity", {1.980492, 1.843512, 2, 1, 0.5}},
      {"stormer_verlet", {1.990125, 1.912572, 2, 2, 1}},  // a(x+, v_{n+1/2})
      {"velocity_verlet_implicit_velocity", {2, 2, 2, 2, 2}},
      {"time_corrected_verlet", {1.980100, 1.809975, 1.236068, 0.828427, 0.472136}},  // lagged leapfrog
      {"semi_implicit_euler_implicit_damping", {2.020100, 2.209975, 3.236068, 4.828427, 8.472136}},
      {"semi_implicit_euler_exact_damping", {1.980487, 1.839655, 1.556232, 1.452417, 1.416658}},
      {"suvat", {0.04, 0.4, 2, 1, 0.5}},
  };
  const Coefficient zetas[5] = {0.01L, 0.1L, 0.5L, 1, 2};
  for (const auto& row : rows)
    for (std::size_t i = 0; i < 5; ++i)
      EXPECT_NEAR(limit_of(row.id, spring(zetas[i])), row.at[i], 5.1e-7)
          << row.id << " zeta " << double(zetas[i]);
  for (const Coefficient zeta : zetas) {
    const double z = double(zeta);
    EXPECT_NEAR(limit_of("semi_implicit_euler", spring(zeta)), 2 * (std::sqrt(1 + z * z) - z), 1e-12);
    EXPECT_NEAR(limit_of("semi_implicit_euler_implicit_damping", spring(zeta)),
                2 * (std::sqrt(1 + z * z) + z), 1e-12);
    EXPECT_NEAR(limit_of("suvat", spring(zeta)), std::min(1 / z, 4 * z), 1e-12);
  }
  const auto half = stability_limit(method("stormer_verlet").theory(), spring(0.5L));
  ASSERT_EQ(half.later_bands.size(), 1u);  // "2 then [2.828, 4]"
  EXPECT_NEAR(double(half.later_bands[0].first), 2 * std::sqrt(2.0), 1e-12);
  EXPECT_NEAR(double(half.later_bands[0].second), 4, 1e-12);
  EXPECT_NEAR(limit_of("velocity_verlet_predicted_velocity", spring(0.2L)), 1.757, 5e-4);
}

TEST(StabilityTheory, SplittingsOnTheUndampedOscillator) {
  for (const auto* id :
       {"semi_implicit_euler", "chapter_euler", "stormer_verlet", "velocity_verlet_old_velocity",
        "velocity_verlet_predicted_velocity", "velocity_verlet_implicit_velocity"})
    EXPECT_NEAR(limit_of(id, spring(0)), 2, 1e-15) << id;
  EXPECT_NEAR(limit_of("yoshida4", spring(0)), 1.57340194743, 5e-12);
  EXPECT_NEAR(limit_of("position_verlet", spring(0)), 2, 1e-15);
  // gaps are narrower than a scan would notice, and what lies beyond them is not small
  struct Gap {
    const char* id;
    double from, to, next;  // stable up to from and again in [to, next]; next 0: not asked
  };
  for (const Gap& g : {Gap{"pefrl", 2.98945, 3.50542, 0}, Gap{"blanes_moan4", 3.13282, 3.16011, 6.3141},
                       Gap{"yoshida6", 2.26906, 2.32777, 0}}) {
    const auto found = stability_limit(method(g.id).theory(), spring(0));
    EXPECT_NEAR(double(found.limit), g.from, 6e-6) << g.id;
    ASSERT_FALSE(found.later_bands.empty()) << g.id;
    EXPECT_NEAR(double(found.later_bands[0].first), g.to, 6e-6) << g.id;
    if (g.next > 0) {
      EXPECT_NEAR(double(found.later_bands[0].second), g.next, 6e-5) << g.id;
    }
  }
}

TEST(StabilityTheory, NystromMethodsOnTheUndampedOscillator) {
  // Nystrom's own of order 4: det = 1 - z^6/288 + z^8/4608... is below 1 first, so there is a limit; his of
  // order 5 and the pair of order 6 gain energy from the start
  const auto four = method("rkn4").theory();
  const auto& m = four.oscillator;
  // x+ = x (1 - q/2 + q^2/24) + h v (1 - q/6), h v+ = x (-q + q^2/6 - q^3/96) + h v (1 - q/2 + q^2/24)
  const std::vector<Coefficient> xx{1, -1 / 2.0L, 1 / 24.0L}, xv{1, -1 / 6.0L},
      vx{0, -1, 1 / 6.0L, -1 / 96.0L}, vv{1, -1 / 2.0L, 1 / 24.0L};
  for (const auto& [got, wanted] : {std::pair{m.xx, xx}, {m.xv, xv}, {m.vx, vx}, {m.vv, vv}})
    for (std::size_t k = 0; k < got.size(); ++k)
      EXPECT_NEAR(double(got[k]), k < wanted.size() ? double(wanted[k]) : 0, 1e-18);
  EXPECT_EQ(verdict_of("rkn4", spring(0)), Stability::limit);
  EXPECT_EQ(verdict_of("rkn5", spring(0)), Stability::unstable);
  EXPECT_EQ(verdict_of("rkn_dormand_prince64", spring(0)), Stability::unstable);
  EXPECT_EQ(verdict_of("rkn_dormand_prince86", spring(0)), Stability::limit);
  EXPECT_EQ(verdict_of("rkn4", spring(0.1L)), Stability::unknown);
  EXPECT_TRUE(std::isnan(growth_per_step(four, spring(0.1L), 0.5L)));
  // growth: the determinant is the square of the radius where the roots are complex
  const Coefficient q = 0.25L, at_xx = 1 - q / 2 + q * q / 24, at_xv = 1 - q / 6,
                    at_vx = -q + q * q / 6 - q * q * q / 96;
  EXPECT_NEAR(double(growth_per_step(four, spring(0), 0.5L)),
              double(std::log(at_xx * at_xx - at_xv * at_vx) / 2), 1e-18);
}

TEST(StabilityTheory, VDriftsStudyOfAStiffSuspension) {
  const Coefficient k = 600000, m = 168;
  const auto cost_equalised_ms = [&](const Theory& theory, double zeta, int evaluations) {
    const auto p = linear_problem(2, {0, -k / m, 1, -2 * Coefficient(zeta) * std::sqrt(k / m)}, true);
    return 1000 * limit_of(theory, p) / evaluations;
  };
  const Theory suvat = method("suvat").theory(),
               implicit_damping = method("semi_implicit_euler_implicit_damping").theory();
  struct Case {
    double zeta, euler, suvat, semi_implicit, heun, rk4, implicit_damping, last_digit;
  };
  for (const Case& c :
       {Case{0.1, 3.35, 6.69, 30.3, 8.8, 12.3, 37.0, 0.06}, Case{1, 33.5, 16.7, 13.9, 16.7, 11.7, 80.8, 0.06},
        Case{2, 8.97, 8.37, 7.90, 4.5, 3.1, 142, 0.6}}) {
    EXPECT_NEAR(cost_equalised_ms(explicit_euler.theory(), c.zeta, 1), c.euler, 0.06);
    EXPECT_NEAR(cost_equalised_ms(suvat, c.zeta, 1), c.suvat, 0.06);
    EXPECT_NEAR(cost_equalised_ms(semi_implicit_euler.theory(), c.zeta, 1), c.semi_implicit, 0.06);
    EXPECT_NEAR(cost_equalised_ms(heun.theory(), c.zeta, 2), c.heun, 0.06);
    EXPECT_NEAR(cost_equalised_ms(rk4.theory(), c.zeta, 4), c.rk4, 0.06);
    EXPECT_NEAR(cost_equalised_ms(implicit_damping, c.zeta, 1), c.implicit_damping, c.last_digit);
  }
}

}  // namespace
}  // namespace odemark::stability_theory_test
