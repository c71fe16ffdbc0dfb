// Stability of multistep methods from coefficients: published intervals and angles, and the traps near the
// origin.
#include <cmath>
#include <limits>
#include <numbers>

#include "integrators/linear_stability_parts.hpp"
#include "tests/stability_cases.hpp"

namespace odemark::stability_multistep_test {
namespace {

TEST(StabilityMultistep, MultistepTraps) {
  const auto ab4 = multistep({0, 0, 0, -1, 1}, {-9 / 24.0L, 37 / 24.0L, -59 / 24.0L, 55 / 24.0L, 0});
  EXPECT_NEAR(limit_of(ab4, real_axis()), 0.3, 1e-12);  // its locus crosses itself
  const auto two_step_midpoint = multistep({-1, 0, 1}, {0, 2});
  EXPECT_NEAR(limit_of(two_step_midpoint, imaginary_axis()), 1,
              1e-9);  // both roots on the circle all the way
  EXPECT_EQ(stability_limit(two_step_midpoint, real_axis()).verdict, Stability::unstable);
  EXPECT_NEAR(double(growth_per_step(two_step_midpoint, real_axis(), 0.1L)), std::asinh(0.1), 1e-15);
  const auto bdf2 = multistep({1, -4, 3}, {0, 0, 2});
  EXPECT_EQ(stability_limit(bdf2, real_axis()).verdict, Stability::unlimited);
  EXPECT_EQ(stability_limit(bdf2, imaginary_axis()).verdict, Stability::unlimited);
  // BDF3 is A(86.032 degrees)-stable: just inside there is no limit, just outside there is a gap
  const auto bdf3 = multistep({-2, 9, -18, 11}, {0, 0, 0, 6});
  const auto at_angle = [](double degrees) {
    const Coefficient a = Coefficient(degrees) * std::numbers::pi_v<Coefficient> / 180;
    return ray(-std::cos(a), std::sin(a));
  };
  EXPECT_EQ(stability_limit(bdf3, at_angle(86.03)).verdict, Stability::unlimited);
  const auto outside = stability_limit(bdf3, at_angle(86.04));
  EXPECT_EQ(outside.verdict, Stability::limit);
  ASSERT_EQ(outside.later_bands.size(), 1u);
  EXPECT_EQ(outside.later_bands[0].second, std::numeric_limits<Coefficient>::infinity());
  // order 3 and consistent, but rho has the root -5
  EXPECT_EQ(stability_limit(multistep({-5, 4, 1}, {2, 4}), real_axis()).verdict, Stability::unstable);
}

TEST(StabilityMultistep, PublishedIntervalsOfAdamsMethods) {
  // Lambert, Numerical Methods for Ordinary Differential Systems, 1991, table 3.2
  struct Case {
    const char* id;
    double real;
  };
  for (const Case& c :
       {Case{"adams_bashforth4", 3.0 / 10}, Case{"adams_bashforth5", 90.0 / 551},
        Case{"adams_bashforth6", 5.0 / 57}, Case{"adams_moulton3", 6}, Case{"adams_moulton4", 3},
        Case{"adams_moulton5", 90.0 / 49}, Case{"adams_moulton6", 45.0 / 38}})
    EXPECT_NEAR(limit_of(c.id, real_axis()), c.real, 1e-12) << c.id;
  EXPECT_NEAR(limit_of("leapfrog", imaginary_axis()), 1, 1e-9);
  for (const auto* id : {"leapfrog", "nystrom_multistep3", "nystrom_multistep4", "milne_simpson4"})
    EXPECT_EQ(verdict_of(id, real_axis()), Stability::unstable) << id << " is only weakly stable";
}

TEST(StabilityMultistep, PredictorCorrectors) {
  // the polynomial is that of the pair, not of its corrector: the limit is a root of it
  for (const auto* id :
       {"adams_bashforth_moulton22", "adams_bashforth_moulton33", "adams_bashforth_moulton34",
        "adams_bashforth_moulton44", "adams_bashforth_moulton45", "adams_bashforth_moulton55"}) {
    const Theory theory = method(id).theory();
    const double limit = limit_of(theory, real_axis());
    EXPECT_NEAR(double(amplification(theory, Coefficient(-limit))), 1, 1e-12) << id;
    EXPECT_LT(double(amplification(theory, Coefficient(-0.999 * limit))), 1) << id;
    EXPECT_GT(double(amplification(theory, Coefficient(-1.001 * limit))), 1) << id;
  }
  // same name in most books, two methods: their limits are an eighth apart
  EXPECT_NEAR(limit_of("adams_bashforth_moulton33", real_axis()), 1.728783568, 1e-9);
  EXPECT_NEAR(limit_of("adams_bashforth_moulton34", real_axis()), 1.934608421, 1e-9);
  // Milne's method is stable nowhere near 0, but is from 0.3 on (P. E. Chase, J. ACM 9 (1962) 457-468)
  const auto milne = stability_limit(method("milne_simpson4").theory(), real_axis());
  ASSERT_EQ(milne.later_bands.size(), 1u);
  EXPECT_NEAR(double(milne.later_bands[0].first), 0.3, 1e-12);
  EXPECT_NEAR(double(milne.later_bands[0].second), 0.844, 5e-4);
}

/// With roots computed to 1e-9 to 1e-12 these seem stable on the imaginary axis up to 0.008, 0.077, 0.06 and
/// 0.043; they are stable nowhere.
TEST(StabilityMultistep, NoFalseIntervalNearTheOrigin) {
  struct Case {
    const char* id;
    double seems_stable_to;
    int power;  // of w dt in the growth per step
  };
  for (const Case& c : {Case{"adams_bashforth2", 0.008, 4}, Case{"adams_bashforth6", 0.077, 8},
                        Case{"adams_moulton4", 0.06, 6}, Case{"adams_bashforth_moulton44", 0.043, 6}}) {
    const Theory theory = method(c.id).theory();
    const auto found = stability_limit(theory, imaginary_axis());
    EXPECT_EQ(found.verdict, Stability::unstable) << c.id;
    EXPECT_EQ(found.limit, 0) << c.id;
    for (const double part : {1e-3, 0.01, 0.1, 0.5, 1.0})
      EXPECT_GT(double(growth_per_step(theory, imaginary_axis(), Coefficient(part * c.seems_stable_to))), 0)
          << c.id << " at " << part;
    const Coefficient y = 1e-4L;
    const Coefficient ratio =
        growth_per_step(theory, imaginary_axis(), 2 * y) / growth_per_step(theory, imaginary_axis(), y);
    EXPECT_NEAR(double(std::log2(ratio)), c.power, 1e-4) << c.id;
    EXPECT_LT(double(amplification(theory, WideComplex(0, 0.4L * Coefficient(c.seems_stable_to)))) - 1, 1e-9)
        << c.id << ": the trap is one";
  }
  EXPECT_NEAR(double(growth_per_step(method("adams_bashforth2").theory(), imaginary_axis(), 1e-4L) / 1e-16L),
              0.25, 1e-6);
}

TEST(StabilityMultistep, AnglesOfBdf) {
  struct Case {
    const char* id;
    double degrees;  // Hairer & Wanner, Solving ODEs II, V.2, table 2.1
  };
  for (const Case& c : {Case{"bdf2", 90}, Case{"bdf3", 86.03}, Case{"bdf4", 73.35}, Case{"bdf5", 51.84},
                        Case{"bdf6", 17.84}}) {
    const Theory theory = method(c.id).theory();
    const auto verdict_at = [&](double degrees) {
      const Coefficient a = Coefficient(degrees) * std::numbers::pi_v<Coefficient> / 180;
      return stability_limit(theory, degrees >= 90 ? imaginary_axis() : ray(-std::cos(a), std::sin(a)))
          .verdict;
    };
    EXPECT_EQ(verdict_at(c.degrees == 90 ? 90 : c.degrees - 0.01), Stability::unlimited) << c.id;
    if (c.degrees < 90) {
      EXPECT_NE(verdict_at(c.degrees + 0.01), Stability::unlimited) << c.id;
    }
  }
}

TEST(StabilityMultistep, EveryMultistepMethodMeetsTheRootCondition) {
  int asked = 0;
  for (const auto& m : suite_methods()) {
    const Theory theory = m.theory();
    if (!detail::is_multistep(theory)) continue;
    ++asked;
    EXPECT_TRUE(detail::zero_stable(theory)) << m.id;
  }
  EXPECT_GE(asked, 20);
  // BDF7, the first of its family that does not (Cryer, BIT 12 (1972) 17-25)
  Theory bdf7;
  bdf7.rho.assign(8, 0), bdf7.sigma.assign(8, 0), bdf7.sigma[7] = 1;
  for (std::size_t j = 1; j <= 7; ++j) {
    Coefficient binomial = 1;
    for (std::size_t i = 0; i <= j; ++i) {
      bdf7.rho[7 - i] += (i % 2 == 0 ? 1 : -1) * binomial / Coefficient(j);
      binomial *= Coefficient(j - i) / Coefficient(i + 1);
    }
  }
  EXPECT_FALSE(detail::zero_stable(bdf7));
}

}  // namespace
}  // namespace odemark::stability_multistep_test
