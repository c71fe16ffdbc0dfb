// Stability of the methods of engines and structural codes, from their theory: closed forms and known limits.
#include <cmath>
#include <limits>

#include "tests/stability_cases.hpp"

namespace odemark::stability_game_test {
namespace {

TEST(StabilityGame, ImplicitStepsHaveNoLimit) {
  for (const auto* id : {"linearly_implicit_euler", "xpbd_spring", "xpbd_spring_substeps8", "newmark_beta",
                         "hht_alpha_005", "generalised_alpha_r08"})
    for (const Coefficient zeta : {0.0L, 0.01L, 0.1L, 0.5L, 1.0L, 2.0L})
      EXPECT_EQ(verdict_of(id, spring(zeta)), Stability::unlimited) << id << " zeta " << double(zeta);
}

TEST(StabilityGame, TheDragRule) {
  // while h d < 1 the step is stable where left z^2 <= 2 (1 + left), left = 1 - 2 zeta z; from there on it
  // freezes
  for (const Coefficient zeta : {0.01L, 0.05L, 0.1L}) {
    const auto found = stability_limit(method("engine_drag_rule").theory(), spring(zeta));
    ASSERT_EQ(found.verdict, Stability::limit);
    const auto excess = [&](Coefficient z) {
      const Coefficient left = 1 - 2 * zeta * z;
      return double(left * z * z - 2 * (1 + left));
    };
    EXPECT_NEAR(excess(found.limit), 0, 1e-14);
    ASSERT_EQ(found.later_bands.size(), 1u);
    EXPECT_NEAR(excess(found.later_bands[0].first), 0, 1e-12);
    EXPECT_EQ(found.later_bands[0].second, std::numeric_limits<Coefficient>::infinity());
  }
  EXPECT_EQ(verdict_of("engine_drag_rule", spring(0.5L)), Stability::unlimited);
  EXPECT_NEAR(limit_of("engine_drag_rule", spring(0)), 2, 1e-12);
}

TEST(StabilityGame, SubstepsMultiplyTheLimit) {
  for (const Coefficient zeta : {0.01L, 0.1L, 0.5L, 1.0L, 2.0L}) {
    EXPECT_NEAR(limit_of("semi_implicit_euler_substeps4", spring(zeta)),
                4 * limit_of("semi_implicit_euler", spring(zeta)), 1e-9);
    EXPECT_NEAR(limit_of("rk4_substeps2", spring(zeta)), 2 * limit_of("rk4", spring(zeta)), 1e-9);
    const Theory exact = theory_of_substeps(method("semi_implicit_euler_exact_damping").theory(), 3);
    EXPECT_NEAR(limit_of(exact, spring(zeta)),
                3 * limit_of("semi_implicit_euler_exact_damping", spring(zeta)), 1e-9);
    const Theory old = theory_of_substeps(method("velocity_verlet_old_velocity").theory(), 2);
    EXPECT_NEAR(limit_of(old, spring(zeta)), 2 * limit_of("velocity_verlet_old_velocity", spring(zeta)),
                1e-9);
  }
}

TEST(StabilityGame, WhatStructuralMethodsLeaveOfInfiniteSteps) {
  const auto radius = [](const char* id) {
    return double(std::exp(growth_per_step(method(id).theory(), spring(0), 1e7L)));
  };
  EXPECT_NEAR(radius("newmark_beta"), 1, 1e-12);
  EXPECT_NEAR(radius("generalised_alpha_r08"), 0.8,
              1e-4);  // a triple eigenvalue: the cube root of a rounding
  // the characteristic polynomial of HHT at infinity has the double root (alpha - 1)/(alpha + 1) and
  // alpha/(alpha - 1)
  EXPECT_NEAR(radius("hht_alpha_005"), 0.95 / 1.05, 1e-5);
  EXPECT_LT(radius("linearly_implicit_euler"), 1e-6);
}

}  // namespace
}  // namespace odemark::stability_game_test
