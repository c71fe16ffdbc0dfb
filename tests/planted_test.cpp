// Faults planted in methods are found by name, by the order verdict and by the gate; the right versions pass.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "bench/execute.hpp"
#include "bench/json_line.hpp"
#include "reports/check.hpp"
#include "reports/observed_order.hpp"
#include "tests/planted/planted_methods.hpp"

namespace odemark::planted_test {
namespace {

using testing::HasSubstr;

constexpr std::string_view demands = R"(
schema = 1

[[rule]]
case = "*"
order = "claimed"
)";

/// The suite with every faulty method in it, as a user would register his own.
const Registry& registry() {
  static const Registry all = [] {
    Registry made = suite_registry();
    for (auto method :
         {erase_method<planted::rk4_wrong_coefficient>(), erase_method<planted::rk4_integer_division>(),
          erase_method<planted::trapezoid_of_old_slopes>(), erase_method<planted::trapezoid_of_new_slopes>(),
          erase_method<planted::adams_copied_start>(), erase_method<planted::adams_bashforth_poor_start>(),
          erase_method<planted::adams_bashforth_moulton_poor_start>(),
          erase_method<planted::bdf_poor_start>(), erase_method<planted::pefrl_wrong_digit>()})
      made.methods.push_back(std::move(method));
    return made;
  }();
  return all;
}

std::vector<Row> rows_of(std::string_view method) {
  PlanOptions options;
  options.methods = std::string(method), options.problems = "pendulum,kepler_e02,lorenz63";
  options.settings = "", options.timing = false;
  std::vector<Row> rows;
  ExecuteOptions execution;
  execution.sink = [&](const Row& row) {
    // through the file that reports and the gate read, not past it
    rows.push_back(
        parse_results(to_json_line(RunHeader{}) + "\n" + to_json_line(row) + "\n", "rows").rows.at(0));
  };
  std::vector<PlannedRun> fixed;
  for (auto& planned : make_plan(registry(), options))
    if (planned.request.steps) fixed.push_back(std::move(planned));
  EXPECT_TRUE(execute(fixed, execution));
  return rows;
}

CheckResult gate(const std::vector<Row>& rows) {
  return check(rows, {}, parse_thresholds(demands), load_baseline(std::nullopt));
}

class Faulty : public testing::TestWithParam<const char*> {};
class Right : public testing::TestWithParam<const char*> {};

TEST_P(Faulty, IsFoundByTheOrderVerdict) {
  // one problem may hide a fault (on lorenz63 the error of a copied start is small beside the others), not
  // two; and a method that converges to nothing has no order that could be below another: its verdict is
  // inconclusive
  int caught = 0;
  for (const auto& order : observed_orders(rows_of(GetParam())))
    caught += order.verdict == OrderVerdict::fails || order.verdict == OrderVerdict::inconclusive;
  EXPECT_GE(caught, 2);
}

TEST_P(Faulty, IsFoundByTheGateAndNamed) {
  const CheckResult result = gate(rows_of(GetParam()));
  EXPECT_EQ(exit_code(result), 1);
  EXPECT_GE(count(result, Outcome::fail), 1);
  EXPECT_THAT(to_console(result), HasSubstr(GetParam()));
  std::string markdown = to_markdown(result);  // where underscores are escaped
  std::erase(markdown, '\\');
  EXPECT_THAT(markdown, HasSubstr(GetParam()));
}

TEST_P(Right, PassesBoth) {
  const auto rows = rows_of(GetParam());
  for (const auto& order : observed_orders(rows))
    EXPECT_TRUE(order.verdict == OrderVerdict::holds || order.verdict == OrderVerdict::exceeds)
        << order.id.problem << ": " << order.reason;
  const CheckResult result = gate(rows);
  EXPECT_EQ(exit_code(result), 0) << to_console(result);
}

INSTANTIATE_TEST_SUITE_P(Planted, Faulty,
                         testing::Values("rk4_wrong_coefficient", "rk4_integer_division",
                                         "trapezoid_of_old_slopes", "adams_copied_start",
                                         "adams_bashforth_poor_start", "adams_bashforth_moulton_poor_start",
                                         "bdf_poor_start", "pefrl_wrong_digit"));
INSTANTIATE_TEST_SUITE_P(Suite, Right,
                         testing::Values("rk4", "heun", "trapezoid_of_new_slopes", "adams_bashforth3",
                                         "adams_bashforth_moulton33", "bdf3", "pefrl"));

}  // namespace
}  // namespace odemark::planted_test
