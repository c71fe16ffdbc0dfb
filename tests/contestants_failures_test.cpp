// What third-party solvers make of problems that break: a status each, no crash, no hang, nothing printed.
#include <gmock/gmock.h>

#include "tests/support/contestant_problems.hpp"

namespace odemark::contestants_failures_test {
namespace {

using namespace probe;
using testing::AnyOf;

Control either(bool fixed) {
  ErrorControl tolerance{1e-6, 1e-6};
  tolerance.step_limit = 200'000;
  return fixed ? Control(FixedSteps{200}) : Control(tolerance);
}

/// Solvers must not write to anybody's terminal.
class contestant_failures : public testing::Test {
 protected:
  void SetUp() override { testing::internal::CaptureStderr(); }
  void TearDown() override { EXPECT_EQ(testing::internal::GetCapturedStderr(), ""); }
};

/// The latest place of a step, as part of it, at which a solver looks at the slope. GSL's implicit steppers
/// take two half steps, of the midpoint rule or of Gauss with two stages, and estimate their error from those
/// alone: what lies behind the last node of the second half they have not seen when they accept a step.
double latest_look(const AnyMethod& m) {
  if (m.id == "gsl_rk2imp") return 3.0 / 4;
  if (m.id == "gsl_rk4imp") return 1.0 / 2 + (1.0 / 2 + std::sqrt(3.0) / 6) / 2;
  return 1;
}

TEST_F(contestant_failures, a_slope_that_becomes_nan_is_never_a_number) {
  for (const bool fixed : {true, false})
    for_each_contestant(nan_after_one(), fixed, [&](const AnyMethod& m) {
      double from = 0, to = 0;  // of the last step that was accepted
      Trace<double> trace;
      trace.on_step = [&](double t, const double*) {
        from = to, to = t;
        return true;
      };
      const End end = solve(m, nan_after_one(), either(fixed), 2, {1}, &trace);
      EXPECT_THAT(end.report.status, AnyOf(RunStatus::not_finite, RunStatus::newton_diverged,
                                           RunStatus::step_underflow, RunStatus::solver_failed))
          << m.id;
      if (end.report.status == RunStatus::solver_failed) {
        EXPECT_NE(end.report.reason, "");
      }
      EXPECT_EQ(std::isfinite(end.y[0]), end.report.status != RunStatus::not_finite) << m.id;
      if (!std::isfinite(end.y[0])) return;
      EXPECT_EQ(end.report.t_reached, to) << m.id;
      EXPECT_LE(from + latest_look(m) * (to - from), 1 + 1e-12) << m.id;
      EXPECT_GE(to, 1 - 0.011) << m.id;
    });
}

TEST_F(contestant_failures, an_exception_comes_out_where_the_run_was_asked_for) {
  for (const bool fixed : {true, false})
    for_each_contestant(throwing_after_one(), fixed, [&](const AnyMethod& m) {
      EXPECT_TRUE(solve(m, throwing_after_one(), either(fixed), 2, {1}).threw) << m.id;
      EXPECT_FALSE(solve(m, throwing_after_one(), either(fixed), 0.5, {1}).threw) << m.id;
    });
}

TEST_F(contestant_failures, an_exception_in_the_jacobian_too) {
  Erased system = driven();
  system.jacobian_call = [](const void*, double, const double*, double*) {
    throw std::domain_error("no slope");
  };
  for (const bool fixed : {true, false})
    for_each_contestant(system, fixed, [&](const AnyMethod& m) {
      const End end = solve(m, system, either(fixed), 2, {0, 1});
      EXPECT_EQ(end.threw, end.work.jacobian > 0) << m.id;
      if (m.needs & Ability::jacobian) {
        EXPECT_TRUE(end.threw) << m.id;
      }
    });
}

TEST_F(contestant_failures, error_control_stops_at_a_singularity) {
  for_each_contestant(blowing_up(), false, [&](const AnyMethod& m) {
    const End end = solve(m, blowing_up(), either(false), 2, {1});
    EXPECT_THAT(end.report.status,
                AnyOf(RunStatus::step_underflow, RunStatus::newton_diverged, RunStatus::not_finite,
                      RunStatus::solver_failed, RunStatus::step_limit))
        << m.id;
    EXPECT_NEAR(end.report.t_reached, 1, 1e-3) << m.id;
  });
}

TEST_F(contestant_failures, fixed_steps_through_a_singularity_end) {
  for_each_contestant(blowing_up(), true, [&](const AnyMethod& m) {
    const End end = solve(m, blowing_up(), either(true), 2, {1});
    // explicit steps overflow, Newton iterations give up; a linearly implicit step may jump to the other side
    if (m.id != "odeint_rosenbrock4") {
      EXPECT_THAT(end.report.status, AnyOf(RunStatus::not_finite, RunStatus::newton_diverged)) << m.id;
    }
  });
}

TEST_F(contestant_failures, growth_beyond_all_bounds_is_not_an_error_of_the_request) {
  Erased growth = nan_after_one();
  growth.rhs_call = [](const void*, double, const double* y, double* d) { d[0] = 3 * y[0]; };
  growth.jacobian_call = [](const void*, double, const double*, double* j) { j[0] = 3; };
  for_each_contestant(growth, true, [&](const AnyMethod& m) {
    const End end = solve(m, growth, FixedSteps{5000}, 100, {1});
    EXPECT_EQ(end.report.status, RunStatus::reached_end) << m.id << " " << end.report.reason;
    EXPECT_GT(end.y[0], 1e100) << m.id;
  });
}

TEST_F(contestant_failures, a_nan_jacobian_is_a_failed_iteration) {
  for (const bool fixed : {true, false})
    for_each_contestant(nan_jacobian(), fixed, [&](const AnyMethod& m) {
      const End end = solve(m, nan_jacobian(), either(fixed), 2, {0, 1});
      if (end.work.jacobian == 0) return;
      EXPECT_THAT(end.report.status,
                  AnyOf(RunStatus::newton_diverged, RunStatus::not_finite, RunStatus::step_underflow))
          << m.id;
    });
}

TEST_F(contestant_failures, the_step_limit_holds) {
  for_each_contestant(driven(), false, [&](const AnyMethod& m) {
    ErrorControl control{1e-6, 1e-6};
    control.step_limit = 10;
    const End end = solve(m, driven(), control, 100, {0, 1});
    EXPECT_EQ(end.report.status, RunStatus::step_limit) << m.id;
    EXPECT_GE(end.report.accepted + end.report.rejected, 10) << m.id;
    EXPECT_LT(end.report.accepted + end.report.rejected, 40) << m.id;
    EXPECT_GT(end.report.t_reached, 0) << m.id;
    EXPECT_LT(end.report.t_reached, 100) << m.id;
  });
}

TEST_F(contestant_failures, impossible_tolerances_end) {
  for (const double tolerance : {1e-30, 0.0})
    for_each_contestant(driven(), false, [&](const AnyMethod& m) {
      ErrorControl control{tolerance, tolerance};
      control.step_limit = 3000;
      const End end = solve(m, driven(), control, 10, {0, 1});
      EXPECT_THAT(end.report.status, AnyOf(RunStatus::step_underflow, RunStatus::newton_diverged,
                                           RunStatus::solver_failed, RunStatus::step_limit))
          << m.id;
      if (m.provider == "sundials") {
        EXPECT_NE(end.report.reason, "") << m.id;
      }
    });
}

TEST_F(contestant_failures, the_observer_stops_a_run) {
  for (const bool fixed : {true, false})
    for_each_contestant(driven(), fixed, [&](const AnyMethod& m) {
      Trace<double> trace;
      trace.grid = {1, 2, 3, 4};
      int seen = 0;
      trace.on_step = [&](double, const double*) { return ++seen < 3; };
      const End end = solve(m, driven(), either(fixed), 4, {0, 1}, &trace);
      EXPECT_EQ(end.report.status, RunStatus::time_limit) << m.id;
      EXPECT_EQ(seen, 3) << m.id;
      EXPECT_EQ(end.report.accepted, 3) << m.id;
      EXPECT_LT(end.report.t_reached, 4) << m.id;
      EXPECT_EQ(trace.samples.size(), 8u) << m.id;
      EXPECT_TRUE(std::isnan(trace.samples[7])) << m.id;
    });
}

TEST_F(contestant_failures, what_a_method_cannot_do_is_said) {
  for (const auto& m : contestants()) {
    const auto asked = [&](const Control& control) { return solve(m, driven(), control, 1, {0, 1}).report; };
    if (!m.takes_fixed_steps) {
      EXPECT_EQ(asked(FixedSteps{10}).status, RunStatus::not_applicable) << m.id;
    }
    if (!m.takes_fixed_steps) {
      EXPECT_NE(asked(FixedSteps{10}).reason, "") << m.id;
    }
    if (!m.takes_error_control) {
      EXPECT_EQ(asked(ErrorControl{1e-3, 1e-3}).status, RunStatus::not_applicable) << m.id;
    }
    EXPECT_EQ(asked(FixedSteps{10, true}).status, RunStatus::not_applicable) << m.id;
  }
}

}  // namespace
}  // namespace odemark::contestants_failures_test
