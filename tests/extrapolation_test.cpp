// Extrapolation: its rows are Runge-Kutta methods of the orders claimed, and its order follows the tolerance.
#include <gtest/gtest.h>

#include "integrators/methods/gragg_bulirsch_stoer10.hpp"
#include "integrators/methods/gragg_bulirsch_stoer4.hpp"
#include "integrators/methods/gragg_bulirsch_stoer6.hpp"
#include "integrators/methods/gragg_bulirsch_stoer8.hpp"
#include "integrators/order_conditions.hpp"
#include "tests/support/runs.hpp"

namespace odemark::extrapolation_test {
namespace {

template <const auto& method, std::size_t Stages>
void expect_orders() {
  const Tableau tableau = method.theory().tableau;
  ASSERT_EQ(tableau.stages, Stages) << method.id;
  std::array<std::array<Coefficient, Stages>, Stages> a{};
  std::array<Coefficient, Stages> b{}, embedded{};
  for (std::size_t i = 0; i < Stages; ++i) {
    for (std::size_t j = 0; j < Stages; ++j) a[i][j] = tableau.a[i * Stages + j];
    b[i] = tableau.b[i], embedded[i] = tableau.b_embedded[i];
  }
  const int highest = std::min(method.order + 1, highest_tree_order);
  EXPECT_EQ(algebraic_order(a, b, highest), method.order) << method.id;
  EXPECT_EQ(algebraic_order(a, embedded, method.embedded_order + 1), method.embedded_order) << method.id;
}

TEST(Extrapolation, RowsAreRungeKuttaMethodsOfTheOrdersClaimed) {
  expect_orders<gragg_bulirsch_stoer4, 5>();
  expect_orders<gragg_bulirsch_stoer6, 10>();
  expect_orders<gragg_bulirsch_stoer8, 17>();
  expect_orders<gragg_bulirsch_stoer10, 26>();
}

struct Result {
  long evaluations, accepted;
  double error;
};
Result run_with(std::string_view id, const AnyProblem& problem, double tolerance,
                const std::vector<long double>& end) {
  const AnyMethod& method = suite_method(id);
  ErrorControl control{tolerance, tolerance};
  control.scale = problem.scale.data();
  WorkCounts work;
  const CountingSystem<double> counting(problem.system<double>(), work);
  std::vector<double> y = problem.initial;
  const auto report =
      method.runs<double>().solve(counting.view(), control, problem.t_begin, problem.t_end, y);
  EXPECT_EQ(report.status, RunStatus::reached_end) << id;
  return {work.rhs, report.accepted, scaled_gap(problem, y, end)};
}

TEST(Extrapolation, TheOrderFollowsTheTolerance) {
  for (const char* id : {"lorenz63", "kepler_e06"}) {
    const auto problem = suite_problem(id);
    const auto end = fine_end(problem, 4096);
    const Result loose = run_with("gragg_bulirsch_stoer", problem, 1e-6, end),
                 tight = run_with("gragg_bulirsch_stoer", problem, 1e-12, end);
    EXPECT_LT(tight.error, 1e-4 * loose.error) << id;
    // at order 5 a million times less error costs sixteen times the work; steps hardly shrink here
    EXPECT_LT(tight.evaluations, 5 * loose.evaluations) << id;
    EXPECT_LT(tight.accepted, 2 * loose.accepted) << id;
    EXPECT_GT(double(tight.evaluations) / double(tight.accepted),
              1.5 * double(loose.evaluations) / double(loose.accepted))
        << id << ": more rows per step";
    EXPECT_LT(tight.evaluations, run_with("dormand_prince54", problem, 1e-12, end).evaluations / 2) << id;
  }
}

TEST(Extrapolation, LinearlyImplicitStepsFollowTheSlowSolution) {
  const auto problem = suite_problem("robertson");
  const std::vector<long double> unused(problem.size(), 0);
  long before = 0;
  for (const double tolerance : {1e-3, 1e-5, 1e-7, 1e-9}) {
    const Result ran = run_with("linearly_implicit_euler_extrapolation", problem, tolerance, unused);
    EXPECT_LT(ran.accepted, 200) << tolerance;
    EXPECT_GT(ran.evaluations, before) << tolerance;
    before = ran.evaluations;
  }
}

}  // namespace
}  // namespace odemark::extrapolation_test
