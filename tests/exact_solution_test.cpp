// Closed forms solve their equations, invariants stay what they are, and both meet a computed solution.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "bench/solve.hpp"
#include "tests/support/wide_views.hpp"

namespace odemark::exact_solution_test {
namespace {

/// A time inside the interval, away from every switch.
std::vector<Wide> times_of(const AnyProblem& problem) {
  std::vector<Wide> times;
  for (const double share : {0.03125, 0.171875, 0.40625, 0.703125, 0.984375})
    times.push_back(Wide(problem.t_end) * Wide(share));
  return times;
}

TEST(ExactSolution, StartsAtTheStart) {
  for (const auto& problem : every_preset()) {
    if (!problem.has_exact) continue;
    const WideProblem wide = widened(problem, false);
    ASSERT_TRUE(wide.exact) << problem.id;
    std::vector<Wide> y(wide.size);
    wide.exact(wide.value.get(), Wide(0), wide.initial.data(), y.data());
    for (std::size_t i = 0; i < y.size(); ++i)
      EXPECT_NEAR(to_double(y[i] - wide.initial[i]) / problem.scale[i], 0, 1e-40) << problem.id;
  }
}

TEST(ExactSolution, ItsDerivativeIsTheRightHandSide) {
  int closed_forms = 0;
  for (const auto& problem : every_preset()) {
    if (!problem.has_exact) continue;
    SCOPED_TRACE(problem.id);
    ++closed_forms;
    const WideProblem wide = widened(problem, false);
    std::vector<Wide> before(wide.size), after(wide.size), now(wide.size), slope(wide.size);
    const Wide step = Wide(problem.suggested_dt) * Wide("1e-14");
    for (const Wide& t : times_of(problem)) {
      wide.exact(wide.value.get(), t - step, wide.initial.data(), before.data());
      wide.exact(wide.value.get(), t, wide.initial.data(), now.data());
      wide.exact(wide.value.get(), t + step, wide.initial.data(), after.data());
      wide.rhs(phase_at(problem, wide, t).value.get(), t, now.data(), slope.data());
      for (std::size_t i = 0; i < wide.size; ++i) {
        const double size = problem.scale[i] + std::abs(to_double(slope[i]));
        EXPECT_NEAR(to_double((after[i] - before[i]) / (2 * step) - slope[i]) / size, 0, 1e-20)
            << "component " << i << " at t = " << to_double(t);
      }
    }
  }
  EXPECT_GE(closed_forms, 20);
}

TEST(ExactSolution, InvariantsAreConstantAlongIt) {
  for (const auto& problem : every_preset()) {
    if (!problem.has_exact || problem.invariant_names.empty()) continue;
    SCOPED_TRACE(problem.id);
    const WideProblem wide = widened(problem, false);
    std::vector<Wide> start(problem.invariant_names.size()), now(start), y(wide.size);
    wide.invariants(wide.value.get(), wide.initial.data(), start.data());
    for (const Wide& t : times_of(problem)) {
      wide.exact(wide.value.get(), t, wide.initial.data(), y.data());
      wide.invariants(wide.value.get(), y.data(), now.data());
      for (std::size_t i = 0; i < now.size(); ++i)
        EXPECT_NEAR(to_double(now[i] - start[i]) / (1 + std::abs(to_double(start[i]))), 0, 1e-30)
            << problem.invariant_names[i];
    }
  }
}

/// One smooth piece: no switch in time, no kink of abs. Long Taylor steps know nothing of either.
bool is_smooth(const AnyProblem& problem) {
  if (!problem.smooth()) return false;
  for (const auto& entry : problem.system<double>().tape().entries)
    if (entry.op == TapeOp::absolute) return false;
  return true;
}

/// A piece of the solution short enough to be computed to extended precision in no time.
AnyProblem shortened(const AnyProblem& problem) {
  AnyProblem part = problem;
  part.t_end = std::min(problem.t_end, 4000 * problem.suggested_dt);
  return part;
}
long steps_for(const AnyProblem& problem) {
  return std::lround(std::ceil((problem.t_end - problem.t_begin) / (2 * problem.suggested_dt)));
}

/// On the very decimals that are stored: a third witness beside the two that made them, also across kinks.
TEST(ExactSolution, InvariantsAreConstantAlongTheStoredSolutions) {
  int checked = 0;
  for (const auto& problem : every_preset()) {
    if (problem.invariant_names.empty()) continue;
    SCOPED_TRACE(problem.id);
    const WideProblem wide = widened(problem, false);
    std::vector<Wide> start(problem.invariant_names.size()), now(start), y(wide.size);
    wide.invariants(wide.value.get(), wide.initial.data(), start.data());
    for (const auto& point : truth_of(problem)->points) {
      ++checked;
      for (std::size_t i = 0; i < y.size(); ++i) y[i] = Wide(point.values[i].decimal);
      wide.invariants(wide.value.get(), y.data(), now.data());
      for (std::size_t i = 0; i < now.size(); ++i)
        EXPECT_NEAR(to_double(now[i] - start[i]) / (1 + std::abs(to_double(start[i]))), 0, 1e-19)
            << problem.invariant_names[i] << " at t = " << point.t;
    }
  }
  EXPECT_GE(checked, 500);
}

TEST(ExactSolution, InvariantsAreConstantAlongAFineRun) {
  for (const auto& whole : every_preset()) {
    if (whole.invariant_names.empty() || !is_smooth(whole)) continue;
    SCOPED_TRACE(whole.id);
    const AnyProblem problem = shortened(whole);
    const auto y = fine_end(problem, steps_for(problem));
    const std::vector<long double> y0(problem.initial.begin(), problem.initial.end());
    std::vector<long double> start(problem.invariant_names.size()), now(start);
    problem.invariants_call(problem.value.get(), y0.data(), start.data());
    problem.invariants_call(problem.value.get(), y.data(), now.data());
    for (std::size_t i = 0; i < now.size(); ++i)
      EXPECT_NEAR(double(now[i] - start[i]) / (1 + std::abs(double(start[i]))), 0, 1e-15)
          << problem.invariant_names[i];
  }
}

TEST(ExactSolution, TaylorOfTwentyOrdersComesToTheSamePlace) {
  for (const auto& whole : every_preset()) {
    if (!whole.has_exact || !is_smooth(whole)) continue;
    SCOPED_TRACE(whole.id);
    const AnyProblem problem = shortened(whole);
    const auto computed = fine_end(problem, steps_for(problem));
    const WideProblem wide = widened(problem, false);
    std::vector<Wide> y(wide.size);
    wide.exact(wide.value.get(), Wide(problem.t_end), wide.initial.data(), y.data());
    for (std::size_t i = 0; i < y.size(); ++i)
      EXPECT_NEAR(to_double(y[i] - Wide(computed[i])) / problem.scale[i], 0, 1e-13) << "component " << i;
  }
}

std::vector<Wide> exact_end(const AnyProblem& problem) {
  const WideProblem wide = widened(problem, false);
  std::vector<Wide> y(wide.size);
  wide.exact(wide.value.get(), Wide(problem.t_end), wide.initial.data(), y.data());
  return y;
}

TEST(ExactSolution, ARunThatStopsAtNoSwitchComesNearTheSwitchedClosedForm) {
  for (const auto& problem : every_preset()) {
    if (problem.switch_times.empty() || !problem.has_exact) continue;
    const auto end = solve<long double>(suite_method("dormand_prince54"), problem, FixedSteps{1 << 17});
    const auto y = exact_end(problem);
    for (std::size_t i = 0; i < y.size(); ++i)
      EXPECT_NEAR(to_double(y[i] - Wide(end.y[i])) / problem.scale[i], 0, 1e-3) << problem.id;
  }
}

TEST(ExactSolution, ARunThatStopsWhereItMustComesVeryNear) {
  int in_pieces = 0;
  for (const auto& problem : every_preset()) {
    if (problem.smooth() || !problem.has_exact) continue;
    ++in_pieces;
    ErrorControl control{1e-12, 1e-12};
    control.scale = problem.scale.data();
    std::vector<long double> end(problem.initial.begin(), problem.initial.end());
    Trace<long double> trace;
    std::vector<FoundEvent> found;
    const auto report =
        solve_problem(suite_method("dormand_prince54"), problem, control, end, trace, found, nullptr);
    EXPECT_EQ(report.status, RunStatus::reached_end) << problem.id;
    const auto y = exact_end(problem);
    for (std::size_t i = 0; i < y.size(); ++i)
      EXPECT_NEAR(to_double(y[i] - Wide(end[i])) / problem.scale[i], 0, 1e-8) << problem.id;
  }
  EXPECT_GE(in_pieces, 10);
}

}  // namespace
}  // namespace odemark::exact_solution_test
