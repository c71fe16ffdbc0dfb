// Numerical failure is a named status with a sane time, for every method; it never hangs and never is a
// number.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <thread>

#include "tests/support/probe_families.hpp"
#include "tests/support/runs.hpp"

namespace odemark::failure_test {
namespace {

RunRequest fixed(long steps) {
  RunRequest request;
  request.steps = steps;
  request.trajectory = false;
  request.time_limit_seconds = 10;
  return request;
}
RunRequest controlled(double tolerance) {
  RunRequest request;
  request.rtol = tolerance;
  request.trajectory = false;
  request.time_limit_seconds = 10;
  return request;
}

const std::set<std::string> known{"reached_end", "step_limit",      "step_underflow",
                                  "not_finite",  "newton_diverged", "time_limit",
                                  "rhs_failed",  "solver_failed",   "not_applicable"};

/// Every method of the suite under every control it takes.
template <class F>
void for_each_run(const AnyProblem& problem, const F& judge) {
  for (const auto& method : suite_methods()) {
    if (!can_run<double>(method, problem)) continue;
    for (const bool adaptive : {false, true}) {
      if (adaptive ? !method.takes_error_control : !method.takes_fixed_steps) continue;
      const RunRequest request = adaptive ? controlled(1e-6) : fixed(2000);
      const Row row = run(method, problem, request, "failure");
      SCOPED_TRACE(row.id);
      EXPECT_TRUE(known.contains(row.status)) << row.status;
      EXPECT_LT(row.accepted, 20'000'000);
      judge(method, row, adaptive);
    }
  }
}

TEST(Failure, ASingularityIsNeverPassedByControlledSteps) {
  for (const auto& problem : {probe::problem<probe::Blowup>(), probe::problem<probe::Singularity>()})
    for_each_run(problem, [&](const AnyMethod& method, const Row& row, bool adaptive) {
      EXPECT_FALSE(row.errors.has_value());
      if (!adaptive) return;
      if (method.kind == "chapter listing") return;  // its faults are kept, see below
      EXPECT_NE(row.status, "reached_end");
      EXPECT_GT(row.t_reached, 0.9);
      EXPECT_LT(row.t_reached, 1.1) << row.status;
    });
}

TEST(Failure, ASingularityEndsExplicitFixedSteps) {
  const auto problem = probe::problem<probe::Blowup>();
  for_each_run(problem, [&](const AnyMethod& method, const Row& row, bool adaptive) {
    if (adaptive || method.jumps_over_poles) return;
    EXPECT_NE(row.status, "reached_end") << "a number beyond the end of the solution";
    EXPECT_GT(row.t_reached, 0.9) << row.status;
    EXPECT_LT(row.t_reached, 1.2) << row.status;
    if (!method.solves_equations) {
      EXPECT_EQ(row.status, "not_finite");
    }
  });
}

/// Whether a run comes out on the far side depends on where its last step before the singularity begins: of
/// many step sizes some get there if the method has such a step at all, and none if it has not.
TEST(Failure, WhatJumpsOverASingularitySaysSo) {
  int jumpers = 0;
  for (const auto& method : suite_methods()) {
    int beyond = 0;
    for (const char* settings : {"t_end=2", "t_end=1.7"}) {
      const auto problem = probe::problem<probe::Blowup>(settings);
      if (!can_run<double>(method, problem) || !method.takes_fixed_steps) continue;
      for (long steps = 200; steps < 240; ++steps)
        beyond += solve(method, problem, FixedSteps{steps}).report.status == RunStatus::reached_end;
    }
    EXPECT_EQ(beyond > 0, method.jumps_over_poles) << method.id << ", " << beyond << " of 80 runs";
    EXPECT_EQ(method.note.find("steps over a singularity") != std::string_view::npos, method.jumps_over_poles)
        << method.id;
    jumpers += method.jumps_over_poles;
  }
  EXPECT_GE(jumpers, 1);
}

/// No accepted step has looked at a slope where there is none, and a run with fixed steps goes on until then.
void expect_stop_at(double end, Looks looks, const AnyMethod& method, const AnyProblem& problem,
                    bool adaptive) {
  constexpr long steps = 2000;
  const double h = (problem.t_end - problem.t_begin) / double(steps), rounding = 1e-12;
  const Control control = adaptive ? Control(ErrorControl{1e-6, 1e-6}) : Control(FixedSteps{steps});
  const LastStep last = last_step(method, problem, control);
  const double latest = latest_node(method, looks);
  EXPECT_LE(last.from + latest * (last.to - last.from), end + rounding);
  if (!adaptive) {
    EXPECT_GE(last.to + std::max(1.0, latest) * h, end - rounding);
  }
}

TEST(Failure, NotANumberStopsEveryMethod) {
  const auto problem = probe::problem<probe::Undefined>();
  for_each_run(problem, [&](const AnyMethod& method, const Row& row, bool adaptive) {
    EXPECT_NE(row.status, "reached_end");
    EXPECT_FALSE(row.errors.has_value());
    EXPECT_GT(row.t_reached, 0.9) << row.status;
    if (adaptive && method.kind == "chapter listing") return;  // its faults are kept
    const Looks looks = adaptive ? Looks::of_state_and_estimate : Looks::of_state;
    expect_stop_at(33.0 / 32, looks, method, problem, adaptive);
  });
}

TEST(Failure, AThrowingRightHandSideIsARow) {
  const auto problem = probe::problem<probe::Thrower>();
  for_each_run(problem, [&](const AnyMethod& method, const Row& row, bool adaptive) {
    EXPECT_EQ(row.status, "rhs_failed");
    EXPECT_NE(row.reason.find("the table of forces"), std::string::npos) << row.reason;
    EXPECT_FALSE(row.errors.has_value());
    if (!(method.needs & Ability::recordable) && !adaptive)
      expect_stop_at(1, Looks::all, method, problem, false);
  });
}

TEST(Failure, TooManyStepsIsAStatus) {
  const auto problem = suite_problem("van_der_pol_mu1000");
  for (const auto& method : suite_methods()) {
    if (!method.takes_error_control || !can_run<double>(method, problem)) continue;
    ErrorControl control{1e-6, 1e-6};
    control.step_limit = 50;
    const auto end = solve(method, problem, control);
    EXPECT_EQ(to_string(end.report.status), "step_limit") << method.id;
    EXPECT_EQ(end.report.accepted + end.report.rejected, 50) << method.id;
    EXPECT_GE(end.report.t_reached, 0) << method.id;
    EXPECT_LT(end.report.t_reached, problem.t_end) << method.id;
  }
}

TEST(Failure, TheTimeLimitEndsARun) {
  const auto problem = suite_problem("oscillator", "t_end=1e6");
  for (const auto& method : suite_methods()) {
    if (!method.takes_fixed_steps || !can_run<double>(method, problem)) continue;
    RunRequest request = fixed(50'000'000);
    request.time_limit_seconds = 0.01;
    const auto begin = std::chrono::steady_clock::now();
    const Row row = run(method, problem, request, "failure");
    const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - begin;
    EXPECT_EQ(row.status, "time_limit") << method.id;
    EXPECT_GT(row.accepted, 0) << method.id;
    EXPECT_NEAR(row.t_reached, 0.02 * double(row.accepted), 1e-6 * row.t_reached) << method.id;
    EXPECT_FALSE(row.errors.has_value()) << method.id;
    EXPECT_LT(spent.count(), 10) << method.id;
  }
}

TEST(Failure, AnUnsolvableStageIsNewtonDiverged) {
  // one step of 2 s over x' = x^2: x = 1 + 2 x^2 has no root
  const auto problem = probe::problem<probe::Blowup>();
  for (const char* id : {"implicit_euler", "implicit_trapezoid", "implicit_midpoint", "sdirk2"}) {
    const Row row = run(suite_method(id), problem, fixed(1), "failure");
    EXPECT_EQ(row.status, "newton_diverged") << id;
    EXPECT_EQ(row.t_reached, 0) << id;
    EXPECT_EQ(row.accepted, 0) << id;
  }
}

TEST(Failure, WhatDoesNotApplySaysWhy) {
  for (const auto& id : problem_ids(suite_families())) {
    const auto problem = suite_problem(id);
    for (const auto& method : suite_registry().methods)
      for (const auto scalar :
           {ScalarType::float_type, ScalarType::double_type, ScalarType::long_double_type})
        for (const bool adaptive : {false, true}) {
          RunRequest request = adaptive ? controlled(1e-3) : fixed(1);
          request.scalar = scalar;
          const bool possible = missing_ability(method.needs, problem.abilities).empty() &&
                                (scalar == ScalarType::double_type || method.provider == "odemark") &&
                                (adaptive ? method.takes_error_control : method.takes_fixed_steps);
          if (possible) continue;
          const Row row = run(method, problem, request, "failure");
          EXPECT_EQ(row.status, "not_applicable") << row.id;
          EXPECT_FALSE(row.reason.empty()) << row.id;
          EXPECT_FALSE(row.errors.has_value() || row.timing.has_value()) << row.id;
          EXPECT_EQ(row.work.evaluations, 0) << row.id;
        }
  }
}

TEST(Failure, CompensationWhereThereIsNoneSaysWhy) {
  const auto problem = suite_problem("oscillator");
  for (const auto& method : suite_methods()) {
    if (method.compensated || !method.takes_fixed_steps || !can_run<double>(method, problem)) continue;
    RunRequest request = fixed(16);
    request.compensated = true;
    const Row row = run(method, problem, request, "failure");
    EXPECT_EQ(row.status, "not_applicable") << method.id;
    EXPECT_EQ(row.reason, "has no compensated summation") << method.id;
  }
}

TEST(Failure, ARequestOfBothOrNeitherControlIsABug) {
  const auto problem = suite_problem("oscillator");
  RunRequest neither, both = fixed(16);
  both.rtol = 1e-3;
  EXPECT_THROW(run(suite_method("rk4"), problem, neither, "failure"), std::logic_error);
  EXPECT_THROW(run(suite_method("rk4"), problem, both, "failure"), std::logic_error);
}

}  // namespace
}  // namespace odemark::failure_test
