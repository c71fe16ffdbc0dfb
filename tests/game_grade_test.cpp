// Game-grade updates: that each is the rule its name promises, on the cases for which engines chose it.
#include <gtest/gtest.h>

#include <cmath>

#include "integrators/erase_method.hpp"
#include "integrators/methods/generalised_alpha_r08.hpp"
#include "integrators/methods/hht_alpha_005.hpp"
#include "integrators/methods/time_corrected_verlet.hpp"
#include "tests/support/probe_families.hpp"
#include "tests/support/runs.hpp"

namespace odemark::game_grade_test {
namespace {

std::vector<double> one_step(const char* id, const AnyProblem& problem, std::vector<double> y, double h) {
  suite_method(id).runs<double>().solve(problem.system<double>(), FixedSteps{1}, 0, h, y);
  return y;
}

/// x'' = 20 - d v: a falling body with drag d.
AnyProblem falling(double drag) {
  return suite_problem("drag_ship", "m=1,thrust=20,drag=" + std::to_string(drag));
}

TEST(GameGrade, DampingApartOnAFallingBody) {
  const double h = 0.25, v = 3, d = 1.5;
  const auto problem = falling(d);
  const auto velocity = [&](const char* id) { return one_step(id, problem, {0, v}, h)[1]; };
  EXPECT_NEAR(velocity("semi_implicit_euler"), v + h * (20 - d * v), 1e-14);
  EXPECT_NEAR(velocity("semi_implicit_euler_implicit_damping"), (v + h * 20) / (1 + h * d), 1e-14);
  EXPECT_NEAR(velocity("semi_implicit_euler_exact_damping"), v * std::exp(-h * d) + h * 20, 1e-14);
  EXPECT_NEAR(velocity("engine_drag_rule"), (v + h * 20) * (1 - h * d), 1e-14);
}

TEST(GameGrade, TheDragRuleFallsTooSlowlyAndFreezes) {
  const auto terminal = [](double h, double drag) {
    auto problem = falling(drag);
    std::vector<double> y{0, 0};
    suite_method("engine_drag_rule")
        .runs<double>()
        .solve(problem.system<double>(), FixedSteps{4000}, 0, 4000 * h, y);
    return y[1];
  };
  EXPECT_NEAR(terminal(0.02, 0.5), 20 / 0.5 - 20 * 0.02, 1e-9);
  EXPECT_EQ(terminal(0.02, 50), 0);
  EXPECT_EQ(terminal(0.02, 80), 0);
}

TEST(GameGrade, SuvatIsExactUnderAConstantForce) {
  const auto y = one_step("suvat", falling(0), {1, 2}, 0.75);
  EXPECT_NEAR(y[0], 1 + 2 * 0.75 + 10 * 0.75 * 0.75, 1e-14);
  EXPECT_NEAR(y[1], 2 + 20 * 0.75, 1e-14);
}

TEST(GameGrade, TimeCorrectedVerletErrsWhereTheStepChanges) {
  // ten frames of 1/60 s, then a spike of 0.25 s
  const auto miss = [](double gravity) {
    const auto problem = suite_problem("drag_ship", "m=1,drag=0,thrust=" + std::to_string(gravity));
    const auto& system = problem.system<double>();
    std::vector<double> y{0, 3}, next = y, error = y;
    StepperOf<time_corrected_verlet, ErasedSystem<double>> stepper(system, y);
    stepper.start();
    double t = 0;
    for (int frame = 0; frame < 11; ++frame) {
      const double h = frame < 10 ? 1.0 / 60 : 0.25;
      EXPECT_EQ(stepper.attempt(t, y, h, next, error), StepStatus::ok);
      stepper.accept();
      y = next, t += h;
    }
    return y[0] - (3 * t + gravity * t * t / 2);
  };
  EXPECT_NEAR(miss(0), 0, 1e-14);
  EXPECT_NEAR(miss(9.81), 9.81 * 0.25 * (0.25 - 1.0 / 60) / 2, 1e-13);  // 0.286 m
}

TEST(GameGrade, OneXpbdSolveOfASpringIsImplicitEuler) {
  // C = x, compliance 1/k, damping c: the published update with lambda = 0
  const double k = 4000, m = 2, c = 30, h = 1.0 / 60, x = 0.5, v = -3;
  const double predicted = x + h * v, compliance = 1 / (k * h * h), gamma = c / (k * h);
  const double lambda = (-predicted - gamma * (predicted - x)) / ((1 + gamma) / m + compliance);
  const double moved = predicted + lambda / m;
  const auto problem = suite_problem("damped_spring", "k=4000,m=2,c=30");
  for (const char* id : {"xpbd_spring", "linearly_implicit_euler", "implicit_euler"}) {
    const auto y = one_step(id, problem, {x, v}, h);
    EXPECT_NEAR(y[0], moved, 1e-13) << id;
    EXPECT_NEAR(y[1], (moved - x) / h, 1e-11) << id;
  }
  // on a force that is not linear they part
  const auto pendulum = suite_problem("pendulum");
  EXPECT_GT(std::abs(one_step("xpbd_spring", pendulum, {1, 2}, 0.25)[0] -
                     one_step("linearly_implicit_euler", pendulum, {1, 2}, 0.25)[0]),
            1e-4);
}

TEST(GameGrade, AverageAccelerationIsTheTrapezoidOnLinearForces) {
  const auto problem = suite_problem("damped_spring", "k=3,m=1,c=0.5");
  const auto newmark = one_step("newmark_beta", problem, {1, -2}, 0.5),
             trapezoid = one_step("implicit_trapezoid", problem, {1, -2}, 0.5);
  EXPECT_NEAR(newmark[0], trapezoid[0], 1e-14);
  EXPECT_NEAR(newmark[1], trapezoid[1], 1e-14);
}

inline constexpr auto wrong_gamma = [] {
  auto method = generalised_alpha_r08;
  method.gamma = 11.0L / 19;
  return method;
}();
inline constexpr auto wrong_sign_of_alpha = [] {
  auto method = hht_alpha_005;
  method.alpha_f = -0.05L;
  return method;
}();
static_assert(!wrong_gamma.second_order_and_stable() && !wrong_sign_of_alpha.second_order_and_stable());

TEST(GameGrade, AWrongDigitOfGeneralisedAlphaCostsTheOrder) {
  const auto problem = probe::problem<probe::Driven>();
  const auto end = fine_end(problem, 256);
  const auto order = [&](const AnyMethod& method) {
    return std::log2(scaled_gap(problem, solve(method, problem, FixedSteps{256}).y, end) /
                     scaled_gap(problem, solve(method, problem, FixedSteps{512}).y, end));
  };
  EXPECT_NEAR(order(suite_method("generalised_alpha_r08")), 2, 0.05);
  EXPECT_NEAR(order(suite_method("hht_alpha_005")), 2, 0.05);
  EXPECT_NEAR(order(erase_method<wrong_gamma>()), 1, 0.1);
  EXPECT_NEAR(order(erase_method<wrong_sign_of_alpha>()), 1, 0.1);
}

TEST(GameGrade, SubstepsAreSmallSteps) {
  const auto problem = probe::problem<probe::DrivenDamped>();
  const std::pair<const char*, std::pair<const char*, long>> pairs[] = {
      {"semi_implicit_euler_substeps4", {"semi_implicit_euler", 4}},
      {"xpbd_spring_substeps8", {"xpbd_spring", 8}},
      {"rk4_substeps2", {"rk4", 2}}};
  for (const auto& [id, base] : pairs) {
    const auto whole = solve(suite_method(id), problem, FixedSteps{16}).y,
               parts = solve(suite_method(base.first), problem, FixedSteps{16 * base.second}).y;
    EXPECT_LT(scaled_gap(problem, whole, parts), 1e-14) << id;
    RunRequest request;
    request.steps = 16, request.trajectory = false;
    const Row row = run(suite_method(id), problem, request, "substeps");
    request.steps = 16 * base.second;
    const Row base_row = run(suite_method(base.first), problem, request, "substeps");
    EXPECT_EQ(row.work.evaluations, base_row.work.evaluations) << id;
    EXPECT_EQ(row.work.lu, base_row.work.lu) << id;
  }
}

TEST(GameGrade, LinearlyImplicitMethodsSolveOnceAStep) {
  RunRequest request;
  request.steps = 10, request.trajectory = false;
  const auto problem = probe::problem<probe::DrivenDamped>();
  for (const char* id : {"linearly_implicit_euler", "xpbd_spring", "semi_implicit_euler_implicit_damping"}) {
    const Row row = run(suite_method(id), problem, request, "solves");
    EXPECT_EQ(row.work.lu, 10) << id;
    EXPECT_EQ(row.work.jacobian, 10) << id;
    EXPECT_EQ(row.work.evaluations, 10) << id;
  }
}

}  // namespace
}  // namespace odemark::game_grade_test
