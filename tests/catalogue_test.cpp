// Everything in the two catalogues is complete, unique and consistent with what it says of itself.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "reference/truth.hpp"
#include "reference/verify_solutions.hpp"
#include "tests/support/runs.hpp"

namespace odemark::catalogue_test {
namespace {

bool is_snake_case(std::string_view id) {
  return !id.empty() && std::islower(static_cast<unsigned char>(id.front())) &&
         std::all_of(id.begin(), id.end(),
                     [](unsigned char c) { return std::islower(c) || std::isdigit(c) || c == '_'; });
}

AnyFamily family_called(std::string_view id) {
  const auto& all = suite_families();
  return *std::find_if(all.begin(), all.end(), [&](const AnyFamily& family) { return family.id == id; });
}

TEST(Catalogue, MethodsAreNamedOnceAndDescribed) {
  std::set<std::string_view> ids;
  for (const auto& method : suite_registry().methods) {
    SCOPED_TRACE(method.id);
    EXPECT_TRUE(ids.insert(method.id).second) << "twice in the catalogue";
    EXPECT_TRUE(is_snake_case(method.id));
    EXPECT_FALSE(method.source.empty());
    EXPECT_FALSE(method.kind.empty());
    EXPECT_GE(method.order, 1);
    EXPECT_LE(method.embedded_order, method.order + method.propagates_lower);
    EXPECT_TRUE(!method.propagates_lower || method.embedded_order == method.order + 1);
    EXPECT_TRUE(method.takes_fixed_steps || method.takes_error_control);
    EXPECT_EQ(method.multistep && method.provider == "odemark", !method.starter.empty());
  }
  EXPECT_GE(suite_methods().size(), 40u);
}

TEST(Catalogue, SuiteMethodsRunInEveryNumberType) {
  for (const auto& method : suite_methods()) {
    SCOPED_TRACE(method.id);
    EXPECT_EQ(method.provider, "odemark");
    EXPECT_TRUE(method.runs<float>().solve && method.runs<float>().solve_traced);
    EXPECT_TRUE(method.runs<double>().solve && method.runs<double>().solve_traced);
    EXPECT_TRUE(method.runs<long double>().solve && method.runs<long double>().solve_traced);
    EXPECT_EQ(method.takes_error_control, method.embedded_order > 0);
  }
}

/// R(z) = numerator / denominator agrees with e^z in the coefficients up to the claimed order.
TEST(Catalogue, TheoryAgreesWithTheClaimedOrder) {
  for (const auto& method : suite_methods()) {
    SCOPED_TRACE(method.id);
    const Theory theory = method.theory();
    const int filled = !theory.numerator.empty() + !theory.rho.empty() + !theory.characteristic.empty() +
                       !theory.moves.empty() + !theory.oscillator.xx.empty() +
                       bool(theory.second_order_step) + theory.exact_on_linear_part +
                       !theory.blank_reason.empty();
    EXPECT_EQ(filled, 1) << "exactly one way of saying how it acts on y' = lambda y";
    if (theory.numerator.empty()) continue;
    Coefficient factorial = 1;
    for (int k = 0; k <= method.order; ++k) {
      if (k > 0) factorial *= Coefficient(k);
      // coefficient k of numerator - denominator e^z
      Coefficient gap = std::size_t(k) < theory.numerator.size() ? theory.numerator[std::size_t(k)] : 0;
      Coefficient inverse = 1, size = std::abs(gap);
      for (int j = k; j >= 0; --j) {
        if (j < k) inverse /= Coefficient(k - j);
        if (std::size_t(j) >= theory.denominator.size()) continue;
        const Coefficient term = theory.denominator[std::size_t(j)] * inverse;
        gap -= term, size += std::abs(term);
      }
      EXPECT_NEAR(double(gap * factorial), 0,
                  1e-15 * double(theory.rounding_amplification) * std::max(1.0, double(size * factorial)))
          << "at z^" << k;
    }
  }
}

TEST(Catalogue, PresetsAreNamedOnceAndSound) {
  std::set<std::string> ids;
  for (const auto& family : suite_families()) {
    SCOPED_TRACE(family.id);
    EXPECT_TRUE(is_snake_case(family.id));
    EXPECT_FALSE(family.title.empty() || family.equations.empty() || family.source.empty());
    ASSERT_FALSE(family.presets.empty());
    for (const auto& parameter : family.parameters)
      EXPECT_FALSE(parameter.name.empty() || parameter.meaning.empty());
    for (const auto& preset : family.presets) {
      SCOPED_TRACE(preset.id);
      EXPECT_TRUE(ids.insert(std::string(preset.id)).second) << "twice in the catalogue";
      EXPECT_TRUE(preset.id == family.id || preset.id.starts_with(std::string(family.id) + "_"));
      EXPECT_FALSE(preset.about.empty());
      const AnyProblem problem = family.create(preset, {});
      EXPECT_EQ(problem.id, preset.id);
      EXPECT_GT(problem.t_end, problem.t_begin);
      EXPECT_GT(problem.suggested_dt, 0);
      EXPECT_LE(problem.suggested_dt, problem.t_end);
      ASSERT_EQ(problem.initial.size(), problem.size());
      ASSERT_EQ(problem.scale.size(), problem.size());
      for (std::size_t i = 0; i < problem.size(); ++i) {
        EXPECT_TRUE(std::isfinite(problem.initial[i]));
        EXPECT_TRUE(problem.scale[i] > 0 && std::isfinite(problem.scale[i]));
        EXPECT_FALSE(problem.components[i].name.empty());
      }
    }
  }
}

/// An equation edited after its solution was stored would be compared with nothing.
TEST(Catalogue, StoredSolutionsBelongToTheirPresets) {
  for (const auto& id : problem_ids(suite_families())) {
    const auto problem = find_problem(suite_families(), id);
    EXPECT_EQ(stored_truth_of(problem) != nullptr, !problem.is_large())
        << id << ": make it again with odemark_make_solutions";
  }
  EXPECT_EQ(stored_truth_of(find_problem(suite_families(), "kepler_e06", "e=0.61")), nullptr);
}

TEST(Catalogue, VerifyingFindsTheSolutionOfOtherEquations) {
  AnyFamily kepler = family_called("kepler");
  kepler.create = [](const Preset& preset, const std::vector<Setting>&) {
    AnyProblem other = find_problem(suite_families(), preset.id, "mu=1.0625");
    other.preset = other.id = preset.id;
    return other;
  };
  VerifyRequest request;
  request.presets = {"kepler_e06"};
  const auto results = verify_solutions(
      {kepler}, request, [](const auto&, auto, auto) {}, false);
  ASSERT_EQ(results.size(), 1u);
  EXPECT_THAT(results[0].fault, testing::HasSubstr("another definition"));
  EXPECT_EQ(verify_solutions(
                suite_families(), request, [](const auto&, auto, auto) {}, false)[0]
                .fault,
            "");
}

TEST(Catalogue, EveryBlankHasAReason) {
  for (const auto& method : suite_methods()) {
    if (method.needs == 0) continue;
    EXPECT_FALSE(missing_ability(method.needs, 0).empty()) << method.id;
    EXPECT_TRUE(missing_ability(method.needs, method.needs).empty()) << method.id;
  }
}

}  // namespace
}  // namespace odemark::catalogue_test
