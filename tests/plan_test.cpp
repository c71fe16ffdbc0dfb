// Plans: what may be asked for, what a mistake is answered, and which runs come out in which order.
#include "bench/plan.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <set>

#include "bench/known_as.hpp"
#include "reference/bad_input.hpp"

namespace odemark::plan_test {
namespace {

using testing::AllOf;
using testing::HasSubstr;

const Registry& registry() {
  static const Registry all = suite_registry();
  return all;
}

PlanOptions small() {
  PlanOptions options;
  options.methods = "rk4,heun", options.problems = "oscillator,lorenz63";
  return options;
}

std::string complaint(const std::function<void(PlanOptions&)>& change) {
  PlanOptions options = small();
  change(options);
  try {
    make_plan(registry(), options);
  } catch (const BadInput& e) {
    return e.what();
  }
  return "no complaint";
}

TEST(Plan, MistakesAreOneSentenceWithTheNearestName) {
  EXPECT_EQ(complaint([](auto&) {}), "no complaint");
  EXPECT_THAT(complaint([](auto& o) { o.suite = "quik"; }),
              AllOf(HasSubstr("there is no suite \"quik\""), HasSubstr("did you mean \"quick\"?")));
  EXPECT_THAT(complaint([](auto& o) { o.methods = "rk5"; }),
              AllOf(HasSubstr("there is no method \"rk5\""), HasSubstr("did you mean \"rk4\"?")));
  EXPECT_THAT(complaint([](auto& o) { o.methods = "vervet*"; }), HasSubstr("there is no method \"vervet*\""));
  EXPECT_THAT(complaint([](auto& o) { o.problems = "oscilator"; }),
              AllOf(HasSubstr("there is no problem \"oscilator\""), HasSubstr("\"oscillator\"?")));
  EXPECT_THAT(complaint([](auto& o) { o.problems = "lorenz63", o.settings = "rh=1"; }),
              AllOf(HasSubstr("no parameter \"rh\""), HasSubstr("\"rho\"?")));
  EXPECT_THAT(complaint([](auto& o) { o.scalars = "double,quad"; }), HasSubstr("\"quad\" is no number type"));
  EXPECT_THAT(complaint([](auto& o) { o.filter = "pid"; }), HasSubstr("\"pid\" is no step-size filter"));
}

TEST(Plan, StepsAndTolerancesMustMakeSense) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  for (const double dt : {0.0, -0.1, nan, -inf, inf})
    EXPECT_THAT(complaint([&](auto& o) {
                  o.dts = {0.1, dt};
                }),
                HasSubstr("is no step: it must be a finite number"));
  EXPECT_THAT(complaint([](auto& o) { o.dts = {11}; }), HasSubstr("is longer than the 10 s of oscillator"));
  EXPECT_THAT(complaint([](auto& o) { o.dts = {1e-12}; }), HasSubstr("at most 1e9 are run"));
  for (const double tolerance : {0.0, 1.0, -1e-3, 2.0, nan})
    EXPECT_THAT(complaint([&](auto& o) { o.tolerances = {tolerance}, o.methods = "tsitouras54"; }),
                HasSubstr("is no tolerance: it must lie between 0 and 1"));
}

TEST(Plan, EveryRunHasItsOwnId) {
  for (const auto& suite : suite_names()) {
    PlanOptions options;
    options.suite = suite;
    std::set<std::string> ids;
    const auto plan = make_plan(registry(), options);
    for (const auto& p : plan)
      EXPECT_TRUE(ids.insert(row_id(*p.method, *p.problem, p.request, p.plan)).second)
          << row_id(*p.method, *p.problem, p.request, p.plan);
    EXPECT_GT(ids.size(), 100u) << suite;
  }
}

TEST(Plan, RunsComeByProblemThenMethodFromCoarseToFine) {
  const auto plan = make_plan(registry(), small());
  ASSERT_FALSE(plan.empty());
  EXPECT_EQ(plan.front().problem->id, "oscillator");
  EXPECT_EQ(plan.back().problem->id, "lorenz63");
  for (std::size_t i = 1; i < plan.size(); ++i) {
    const auto &a = plan[i - 1], &b = plan[i];
    if (a.problem->id != b.problem->id || a.method != b.method) continue;
    ASSERT_TRUE(a.request.steps && b.request.steps);
    EXPECT_EQ(*b.request.steps, 2 * *a.request.steps);
  }
}

TEST(Plan, LaddersLandOnTheCommonGrid) {
  for (const auto& id : problem_ids(registry().families)) {
    const auto problem = find_problem(registry().families, id);
    const auto ladder = step_ladder(problem, 9);
    ASSERT_FALSE(ladder.empty()) << id;
    for (std::size_t i = 0; i < ladder.size(); ++i) {
      EXPECT_EQ(ladder[i] % 16, 0) << id;
      EXPECT_LE(ladder[i], 1L << 24) << id;
      if (i > 0) {
        EXPECT_EQ(ladder[i], 2 * ladder[i - 1]) << id;
      }
    }
  }
}

TEST(Plan, OwnStepsEndOnTheEnd) {
  PlanOptions options = small();
  options.problems = "oscillator", options.methods = "rk4", options.dts = {0.1, 1.0 / 3, 10};
  const auto plan = make_plan(registry(), options);
  ASSERT_EQ(plan.size(), 3u);
  EXPECT_EQ(plan[0].request.steps, 100);
  EXPECT_EQ(plan[1].request.steps, 30);
  EXPECT_EQ(plan[2].request.steps, 1);
}

TEST(Plan, OwnTolerancesGoToMethodsThatTakeThem) {
  PlanOptions options = small();
  options.problems = "oscillator", options.methods = "rk4,tsitouras54,chapter_adaptive_euler";
  options.tolerances = {1e-4, 1e-8};
  const auto plan = make_plan(registry(), options);
  ASSERT_EQ(plan.size(), 4u);
  for (const auto& p : plan) {
    EXPECT_NE(p.method->id, "rk4");
    EXPECT_FALSE(p.request.steps);
    EXPECT_EQ(p.request.first_step.has_value(), p.method->kind == "chapter listing");
  }
}

TEST(Plan, ScalarsFilterAndCompensationReachTheRequests) {
  PlanOptions options = small();
  options.problems = "oscillator", options.methods = "rk4,tsitouras54", options.dts = {0.5},
  options.tolerances = {1e-3};
  options.scalars = "float,long_double", options.compensated = true, options.filter = "h211b";
  int floats = 0, compensated = 0, controlled = 0;
  for (const auto& p : make_plan(registry(), options)) {
    floats += p.request.scalar == ScalarType::float_type;
    compensated += p.request.compensated;
    controlled += p.request.rtol.has_value();
    EXPECT_EQ(p.request.filter.id, "h211b");
    EXPECT_FALSE(p.request.rtol && p.request.compensated);
  }
  EXPECT_EQ(floats, 3);
  EXPECT_EQ(compensated, 4);
  EXPECT_EQ(controlled, 2);
}

TEST(plan, names_that_others_use_lead_to_methods_of_the_suite) {
  std::set<std::string_view> ids, names;
  for (const auto& method : registry().methods) ids.insert(method.id);
  for (const auto& [name, id] : known_as) {
    EXPECT_TRUE(ids.contains(id)) << id;
    EXPECT_FALSE(ids.contains(name)) << name << " is a method itself";
    EXPECT_TRUE(names.insert(name).second) << name << " is there twice";
    try {
      find_method(registry(), name);
      ADD_FAILURE() << name;
    } catch (const BadInput& e) {
      EXPECT_THAT(e.what(), testing::HasSubstr("did you mean \"" + std::string(id) + "\"?"));
    }
  }
  EXPECT_THROW(find_method(registry(), "RK45"), BadInput);
}

TEST(Plan, WildcardsAndFamiliesSelect) {
  EXPECT_EQ(select_methods(registry(), "taylor?").size(), 9u);
  EXPECT_EQ(select_methods(registry(), "taylor*").size(), 20u);
  EXPECT_EQ(select_methods(registry(), "").size(), registry().methods.size());
  EXPECT_EQ(select_problems(registry(), "kepler_*").size(), 11u);
  EXPECT_EQ(select_problems(registry(), "kepler").size(), 1u);
  EXPECT_TRUE(matches("*", "") && matches("a*b?d", "axxbcd") && !matches("a?", "a") && !matches("", "a"));
}

TEST(Plan, NothingIsAskedTwiceWhateverThePatterns) {
  PlanOptions options = small();
  options.problems = "oscillator,osc*,oscillator", options.methods = "rk4,rk*,rk4", options.dts = {0.5, 0.5};
  std::multiset<std::string> ids;
  for (const auto& p : make_plan(registry(), options))
    ids.insert(row_id(*p.method, *p.problem, p.request, p.plan));
  for (const auto& id : ids) EXPECT_EQ(ids.count(id), 1u) << id;
}

}  // namespace
}  // namespace odemark::plan_test
