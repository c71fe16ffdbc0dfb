// No step takes memory from the heap: a run of four times as many steps allocates as often, in either tier.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "bench/static_run.hpp"
#include "integrators/stabilised_recurrence.hpp"
#include "tests/support/count_allocations.hpp"
#include "tests/support/probe_families.hpp"
#include "tests/support/runs.hpp"

namespace odemark::allocation_test {
namespace {

template <class F>
long requests_of(F&& f) {
  const long before = heap_requests.load();
  f();
  return heap_requests.load() - before;
}

/// The polynomials of ROCK2 and ROCK4 are tables that a process makes when it first asks for one: the only
/// memory that a method keeps beyond its run, and it must not count for whichever run comes first.
[[maybe_unused]] const bool rock_tables_are_made = stage_cap(StabilisedFamily::rock2) > 0 &&
                                                   stage_cap(StabilisedFamily::rock4) > 0;

/// One preset of each family of up to 28 components (larger ones only take longer), and probes that defeat
/// Newton's iteration and the step control.
const std::vector<AnyProblem>& problems() {
  static const std::vector<AnyProblem> all = [] {
    std::vector<AnyProblem> made;
    for (const auto& family : suite_families())
      if (family.components.size() <= 28) made.push_back(family.create(family.presets.front(), {}));
    made.push_back(suite_problem("drag_ship_quadratic_ahead"));
    made.push_back(suite_problem("van_der_pol_mu100"));
    made.push_back(probe::problem<probe::Driven>());
    made.push_back(probe::problem<probe::DrivenDamped>());
    made.push_back(probe::problem<probe::DrivenTop>());
    made.push_back(probe::problem<probe::Blowup>("t_end=0.96875"));
    return made;
  }();
  return all;
}

/// Few steps and four times as many of the same size; for error control, limits on their number. `solve`
/// returns how often it asked for memory.
template <class F>
void expect_as_many_requests(const AnyMethod& method, const AnyProblem& problem, const F& solve) {
  const double step = (problem.t_end - problem.t_begin) / 64;
  if (method.takes_fixed_steps)
    for (const bool compensated : {false, true}) {
      if (compensated && !method.compensated) continue;
      EXPECT_EQ(solve(FixedSteps{16, compensated}, 16 * step), solve(FixedSteps{64, compensated}, 64 * step))
          << problem.id << (compensated ? ", compensated" : "");
    }
  if (method.takes_error_control) {
    ErrorControl few{1e-4, 1e-4};
    few.scale = problem.scale.data();
    few.step_limit = 25;
    ErrorControl many = few;
    many.step_limit = 150;
    EXPECT_EQ(solve(few, problem.t_end), solve(many, problem.t_end)) << problem.id << ", error control";
  }
}

/// The recording of a force that is switched in time throws; there is nothing to count then.
template <class F>
void unless_switched(const AnyMethod& method, const AnyProblem& problem, const F& f) {
  if (!(method.needs & Ability::recordable) || problem.switch_times.empty()) f();
}

template <class T>
void expect_no_allocation_per_step(const AnyMethod& method, const AnyProblem& problem) {
  const std::vector<T> start(problem.initial.begin(), problem.initial.end());
  std::vector<T> y = start;
  expect_as_many_requests(method, problem, [&](const Control& control, double t_end) {
    y = start;
    return requests_of(
        [&] { method.runs<T>().solve(problem.system<T>(), control, problem.t_begin, t_end, y); });
  });
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
      unless_switched(method, problem, [&] {
        expect_no_allocation_per_step<double>(method, problem);
        expect_no_allocation_per_step<float>(method, problem);
        expect_no_allocation_per_step<long double>(method, problem);
      });
    }
  }
}

TEST(Allocation, NoStepAllocatesInTheStaticTier) {
  for (const auto& run : suite_static_runs()) {
    SCOPED_TRACE(fmt::format("{}/{}", run.family, run.method));
    const AnyMethod& method = suite_method(run.method);
    for (const auto& problem : problems()) {
      if (problem.family != run.family) continue;
      unless_switched(method, problem, [&] {
        std::vector<double> y = problem.initial;
        expect_as_many_requests(method, problem, [&](const Control& control, double t_end) {
          std::copy(problem.initial.begin(), problem.initial.end(), y.begin());
          if (const auto* fixed = std::get_if<FixedSteps>(&control); fixed && fixed->compensated) return 0L;
          return requests_of(
              [&] { run.solve(problem.value.get(), control, problem.t_begin, t_end, y.data()); });
        });
      });
    }
  }
}

}  // namespace
}  // namespace odemark::allocation_test
