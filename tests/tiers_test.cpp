// The static tier ends in the same bits as the erased tier: every method on every family compiled statically.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "bench/static_run.hpp"
#include "reference/bad_input.hpp"
#include "tests/support/runs.hpp"

namespace odemark::tiers_test {
namespace {

/// Every preset, and the first one with each of its parameters moved a little, as far as that is allowed.
std::vector<AnyProblem> variants_of(const AnyFamily& family) {
  std::vector<AnyProblem> variants;
  for (const auto& preset : family.presets) variants.push_back(family.create(preset, {}));
  for (const auto& parameter : variants.front().parameters) {
    const double moved = parameter.value == 0 ? 0.0625 : parameter.value * 1.125;
    try {
      variants.push_back(
          family.create(family.presets.front(), {{std::string(parameter.name), fmt::format("{}", moved)}}));
    } catch (const BadInput&) {
      continue;  // out of its range
    }
  }
  return variants;
}

const AnyFamily& family_called(std::string_view id) {
  const auto& all = suite_families();
  return *std::find_if(all.begin(), all.end(), [&](const AnyFamily& f) { return f.id == id; });
}

void expect_same_end(const StaticRun& inlined, const AnyMethod& method, const AnyProblem& problem,
                     const Control& control) {
  const auto erased = solve(method, problem, control);
  std::vector<double> y = problem.initial;
  const RunReport report =
      inlined.solve(problem.value.get(), control, problem.t_begin, problem.t_end, y.data());
  EXPECT_EQ(to_string(report.status), to_string(erased.report.status)) << problem.id;
  EXPECT_EQ(report.accepted, erased.report.accepted) << problem.id;
  EXPECT_EQ(report.rejected, erased.report.rejected) << problem.id;
  EXPECT_TRUE(same_bits(report.t_reached, erased.report.t_reached)) << problem.id;
  EXPECT_TRUE(same_bits(y, erased.y)) << problem.id << ": " << y[0] << " and " << erased.y[0];
}

/// The recording of a right-hand side that is switched in time throws: there is nothing to compare.
bool can_record(const AnyProblem& problem) {
  try {
    (void)problem.system<double>().tape();
    return true;
  } catch (const std::logic_error&) {
    return false;
  }
}

TEST(Tiers, EveryStaticRunEndsInTheErasedBits) {
  ASSERT_FALSE(suite_static_runs().empty());
  std::string family;
  std::vector<AnyProblem> variants;
  for (const auto& inlined : suite_static_runs()) {
    if (family != inlined.family) {
      family = inlined.family;
      variants = variants_of(family_called(inlined.family));
    }
    const AnyMethod& method = suite_method(inlined.method);
    SCOPED_TRACE(fmt::format("{}/{}", inlined.family, inlined.method));
    for (const auto& problem : variants) {
      if ((method.needs & Ability::recordable) && !can_record(problem)) continue;
      if (method.takes_fixed_steps) {
        expect_same_end(inlined, method, problem, FixedSteps{96});
        expect_same_end(inlined, method, problem, FixedSteps{7});
      }
      if (method.takes_error_control) {
        ErrorControl control{1e-5, 1e-6};
        control.step_limit = 300;
        control.scale = problem.scale.data();
        expect_same_end(inlined, method, problem, control);
        control.filter = h211b_filter;
        control.first_step = problem.t_end / 4;
        expect_same_end(inlined, method, problem, control);
      }
    }
  }
}

TEST(Tiers, EveryMarkedPairThatAppliesIsThereAndNoOther) {
  std::set<std::pair<std::string_view, std::string_view>> marked;
  for (const auto& mark : suite_static_marks()) marked.emplace(mark.family, mark.method);
  ASSERT_TRUE(marked.contains({"lorenz63", "rk4"}));
  ASSERT_TRUE(marked.contains({"lorenz63", "verner87"}));
  ASSERT_FALSE(marked.contains({"oscillator", "verner87"}));
  for (const auto& family : suite_families())
    for (const auto& method : suite_methods()) {
      const bool is_static =
          marked.contains({family.id, method.id}) && missing_ability(method.needs, family.abilities).empty();
      EXPECT_EQ(find_static_run(family.id, method.id) != nullptr, is_static) << family.id << "/" << method.id;
    }
  EXPECT_EQ(find_static_run("oscillator", "no_such_method"), nullptr);
}

}  // namespace
}  // namespace odemark::tiers_test
