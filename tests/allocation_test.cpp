// No step takes memory from the heap: a run of four times as many steps allocates as often, in either tier.
#include "tests/support/count_allocations.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "bench/static_run.hpp"
#include "tests/support/probe_families.hpp"
#include "tests/support/runs.hpp"

namespace odemark {
namespace {

template <class F>
long requests_of(F&& f) {
  const long before = heap_requests.load();
  f();
  return heap_requests.load() - before;
}

/// One preset of each family, and probes that defeat Newton's iteration and the step control.
const std::vector<AnyProblem>& problems() {
  static const std::vector<AnyProblem> all = [] {
    std::vector<AnyProblem> made;
    for (const auto& family : suite_families()) made.push_back(family.create(family.presets.front(), {}));
    made.push_back(suite_problem("drag_ship_quadratic_ahead"));
    made.push_back(suite_problem("van_der_pol_mu100"));
    made.push_back(probe::problem<probe::Driven>());
    made.push_back(probe::problem<probe::Blowup>("t_end=0.96875"));
    return made;
  }();
  return all;
}

template <class T>
void expect_no_allocation_per_step(const AnyMethod& method, const AnyProblem& problem) {
  std::vector<T> start(problem.initial.begin(), problem.initial.end()), y = start;
  const auto solve = [&](const Control& control) {
    y = start;
    return requests_of([&] {
      method.runs<T>().solve(problem.system<T>(), control, problem.t_begin, problem.t_end, y);
    });
  };
  if (method.takes_fixed_steps)
    for (const bool compensated : {false, true}) {
      if (compensated && !method.compensated) continue;
      EXPECT_EQ(solve(FixedSteps{40, compensated}), solve(FixedSteps{160, compensated}))
          << problem.id << (compensated ? ", compensated" : "");
    }
  if (method.takes_error_control) {
    ErrorControl control{1e-4, 1e-4};
    control.scale = problem.scale.data();
    control.step_limit = 50;
    const long few = solve(control);
    control.step_limit = 400;
    EXPECT_EQ(few, solve(control)) << problem.id << ", error control";
  }
}

TEST(Allocation, TheCounterCounts) {
  std::vector<int> kept;
  EXPECT_GE(requests_of([&] { kept.resize(1000); }), 1);
}

TEST(Allocation, NoStepAllocatesInTheErasedTier) {
  for (const auto& method : suite_methods()) {
    SCOPED_TRACE(method.id);
    for (const auto& problem : problems()) {
      if (!can_run<double>(method, problem)) continue;
      try {
        expect_no_allocation_per_step<double>(method, problem);
        expect_no_allocation_per_step<float>(method, problem);
        expect_no_allocation_per_step<long double>(method, problem);
      } catch (const std::logic_error&) {
        EXPECT_TRUE(method.needs & Ability::recordable) << problem.id;  // a force that is switched in time
      }
    }
  }
}

TEST(Allocation, NoStepAllocatesInTheStaticTier) {
  for (const auto& run : suite_static_runs()) {
    SCOPED_TRACE(fmt::format("{}/{}", run.family, run.method));
    const AnyMethod& method = suite_method(run.method);
    for (const auto& problem : problems()) {
      if (problem.family != run.family) continue;
      std::vector<double> y;
      const auto solve = [&](const Control& control) {
        y = problem.initial;
        return requests_of([&] {
          run.solve(problem.value.get(), control, problem.t_begin, problem.t_end, y.data());
        });
      };
      try {
        if (method.takes_fixed_steps) {
          EXPECT_EQ(solve(FixedSteps{40}), solve(FixedSteps{160})) << problem.id;
        }
        if (method.takes_error_control) {
          ErrorControl control{1e-4, 1e-4};
          control.scale = problem.scale.data();
          control.step_limit = 50;
          const long few = solve(control);
          control.step_limit = 400;
          EXPECT_EQ(few, solve(control)) << problem.id << ", error control";
        }
      } catch (const std::logic_error&) {
        EXPECT_TRUE(method.needs & Ability::recordable) << problem.id;
      }
    }
  }
}

}  // namespace
}  // namespace odemark
