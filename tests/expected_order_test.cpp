// What theory takes back of a claimed order, problem by problem, and that gate and rows hold to the rest of
// it.
#include "bench/expected_order.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "bench/json_line.hpp"
#include "bench/run.hpp"
#include "integrators/lowered_order.hpp"
#include "reports/check.hpp"
#include "tests/support/runs.hpp"

namespace odemark::expected_order_test {
namespace {

const AnyMethod& method_called(std::string_view id) {
  for (const auto& method : suite_methods())
    if (method.id == id) return method;
  throw std::out_of_range(std::string(id));
}

TEST(OrderWithDamping, IsWhatTheMovesLeave) {
  const std::pair<const char*, int> known[] = {{"stormer_verlet", 1},
                                               {"position_verlet", 1},
                                               {"velocity_verlet_old_velocity", 1},
                                               {"velocity_verlet_predicted_velocity", 2},
                                               {"velocity_verlet_implicit_velocity", 2},
                                               {"time_corrected_verlet", 1},
                                               {"yoshida8", 1},
                                               {"semi_implicit_euler", 1},
                                               {"newmark_beta", 2},
                                               {"rk4", 4},
                                               {"leapfrog", 2}};
  for (const auto& [id, order] : known) {
    const AnyMethod& method = method_called(id);
    EXPECT_EQ(order_with_damping(method.theory(), method.order), order) << id;
  }
}

TEST(WeakStability, IsASecondRootOnTheCircle) {
  for (const char* id : {"leapfrog", "nystrom_multistep3", "nystrom_multistep4", "milne_simpson4"})
    EXPECT_TRUE(is_weakly_stable(method_called(id).theory())) << id;
  for (const char* id :
       {"adams_bashforth3", "adams_moulton4", "adams_bashforth_moulton33", "bdf2", "bdf6", "rk4"})
    EXPECT_FALSE(is_weakly_stable(method_called(id).theory())) << id;
}

TEST(ExpectedOrder, DependsOnTheProblem) {
  const auto order = [](const char* method, const char* problem) {
    return expected_order(method_called(method), suite_problem(problem)).order;
  };
  EXPECT_EQ(order("stormer_verlet", "oscillator"), 2);
  EXPECT_EQ(order("stormer_verlet", "damped_spring"), 1);
  EXPECT_EQ(order("rk4", "damped_spring"), 4);
  EXPECT_EQ(order("leapfrog", "kepler_e02"), 2);
  EXPECT_EQ(order("leapfrog", "lorenz63"), 0);
  EXPECT_EQ(order("adams_bashforth3", "lorenz63"), 3);
  EXPECT_FALSE(expected_order(method_called("leapfrog"), suite_problem("lorenz63")).reason.empty());
  EXPECT_TRUE(expected_order(method_called("leapfrog"), suite_problem("pendulum")).reason.empty());
}

TEST(ExpectedOrder, IsInTheRowAndInTheFile) {
  RunRequest request;
  request.steps = 64;
  const Row row = run(method_called("stormer_verlet"), suite_problem("damped_spring"), request, "test");
  EXPECT_EQ(row.order, 2);
  EXPECT_EQ(row.expected_order, 1);
  const Row read =
      parse_results(to_json_line(RunHeader{}) + "\n" + to_json_line(row) + "\n", "rows").rows.at(0);
  EXPECT_EQ(read.expected_order, 1);
  EXPECT_EQ(read.expected_because, row.expected_because);
  const Row plain = run(method_called("stormer_verlet"), suite_problem("oscillator"), request, "test");
  EXPECT_EQ(plain.expected_order, std::nullopt);
}

/// Errors that fall like dt^slope.
std::vector<Row> ladder(double slope, std::optional<int> expected) {
  std::vector<Row> rows;
  for (long steps = 16; steps <= 1024; steps *= 2) {
    Row row;
    row.id = "convergence/p/m/double/steps=" + std::to_string(steps), row.plan = "convergence";
    row.problem = "p", row.method = "m", row.provider = "odemark", row.scalar = "double", row.order = 2;
    if (expected) row.expected_order = expected, row.expected_because = "of a reason";
    row.steps = steps, row.dt = 1.0 / double(steps), row.status = "reached_end";
    row.errors.emplace().scaled = 0.05 * std::pow(16 / double(steps), slope);
    rows.push_back(row);
  }
  return rows;
}
CheckResult gate(const std::vector<Row>& rows) {
  return check(rows, {}, parse_thresholds("schema = 1\n[[rule]]\ncase = \"*\"\norder = \"claimed\"\n"),
               load_baseline(std::nullopt));
}

TEST(ExpectedOrder, IsWhatTheGateDemands) {
  EXPECT_EQ(exit_code(gate(ladder(2, std::nullopt))), 0);
  EXPECT_EQ(exit_code(gate(ladder(1, std::nullopt))), 1);
  EXPECT_EQ(exit_code(gate(ladder(1, 1))), 0);
  EXPECT_EQ(exit_code(gate(ladder(0.5, 1))), 1) << "less than is left of the claim";
  EXPECT_THAT(to_console(gate(ladder(0.5, 1))), testing::HasSubstr("1 instead of 2 is expected"));
  const CheckResult nothing = gate(ladder(0.5, 0));
  EXPECT_EQ(count(nothing, Outcome::fail), 0);
  EXPECT_EQ(count(nothing, Outcome::note), 2) << "the order, and that there is no baseline";
}

}  // namespace
}  // namespace odemark::expected_order_test
