// The order estimator on curves whose answer is known: slopes, floors, gaps, and ladders too short to tell.
#include "reports/observed_order.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace odemark::observed_order_test {
namespace {

using testing::HasSubstr;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

Row row_at(double dt, double error, int order, const std::string& scalar = "double") {
  Row row;
  row.problem = "kepler", row.method = "rk4", row.order = order, row.scalar = scalar;
  row.steps = std::lround(10 / dt), row.dt = dt, row.status = "reached_end";
  row.errors.emplace().scaled = error;
  return row;
}

std::vector<Row> curve(int order, double largest_dt, double ratio, int rungs,
                       const std::function<double(double dt)>& error, const std::string& scalar = "double") {
  std::vector<Row> rows;
  for (int i = 0; i < rungs; ++i) {
    const double dt = largest_dt * std::pow(ratio, i);
    rows.push_back(row_at(dt, error(dt), order, scalar));
  }
  return rows;
}

double fourth(double dt) { return 0.5 * std::pow(dt, 4); }

TEST(observed_order, a_clean_slope_holds) {
  const auto order = observed_order(curve(4, 0.5, 0.5, 9, fourth));
  EXPECT_EQ(order.verdict, OrderVerdict::holds);
  EXPECT_NEAR(order.slope.value(), 4, 1e-9);
  EXPECT_NEAR(order.standard_error.value(), 0, 1e-9);
  EXPECT_EQ(order.points, 9);
  EXPECT_DOUBLE_EQ(order.dt_max.value(), 0.5);
  EXPECT_DOUBLE_EQ(order.dt_min.value(), 0.5 / 256);
  EXPECT_TRUE(order.reason.empty());
}

TEST(observed_order, ladders_need_not_halve_nor_be_sorted) {
  auto rows = curve(4, 0.5, 0.7, 12, fourth);
  std::swap(rows[0], rows[7]), std::swap(rows[3], rows[11]);
  rows.push_back(rows[2]);  // the same run in two plans
  const auto order = observed_order(rows);
  EXPECT_NEAR(order.slope.value(), 4, 1e-9);
  EXPECT_EQ(order.points, 12);
  EXPECT_TRUE(std::is_sorted(order.rungs.begin(), order.rungs.end(),
                             [](const Rung& a, const Rung& b) { return a.dt > b.dt; }));
}

TEST(observed_order, round_off_is_outside_the_window) {
  const auto with_floor = [](double dt) { return fourth(dt) + 3e-15 * std::sqrt(1 / dt); };
  const auto order = observed_order(curve(4, 0.5, 0.5, 16, with_floor));
  EXPECT_EQ(order.verdict, OrderVerdict::holds);
  EXPECT_NEAR(order.slope.value(), 4, 0.02);
  EXPECT_GT(order.dt_min.value(), 5e-4);
  EXPECT_LT(order.points, 12);
}

TEST(observed_order, what_the_truth_or_the_problem_cannot_tell_is_not_used) {
  auto rows = curve(4, 0.5, 0.5, 9, fourth);
  for (Row& row : rows) row.truth_floor = 1e-8;
  EXPECT_GE(observed_order(rows).dt_min.value(), std::pow(2e-6, 0.25));
  for (Row& row : rows) row.truth_floor = 0, row.sensitivity = 1e-8;
  EXPECT_GE(observed_order(rows).dt_min.value(), std::pow(2e-6, 0.25));
  for (Row& row : rows) row.sensitivity = nan;  // unknown: nothing can be told
  EXPECT_EQ(observed_order(rows).verdict, OrderVerdict::inconclusive);
}

TEST(observed_order, the_pre_asymptotic_range_is_outside_the_window) {
  const auto bent = [](double dt) { return fourth(dt) * (1 + 300 * dt * dt * dt); };
  const auto order = observed_order(curve(4, 0.5, 0.5, 9, bent));
  EXPECT_EQ(order.verdict, OrderVerdict::holds);
  EXPECT_LT(order.dt_max.value(), 0.1);
  EXPECT_NEAR(order.slope.value(), 4, 0.1);
}

TEST(observed_order, too_good_exceeds_and_says_how) {
  const auto fifth = [](double dt) { return 0.1 * std::pow(dt, 5); };
  const auto order = observed_order(curve(4, 0.5, 0.5, 8, fifth));
  EXPECT_EQ(order.verdict, OrderVerdict::exceeds);
  EXPECT_THAT(order.reason, HasSubstr("superconvergent"));
  const auto steeper = [](double dt) { return 0.1 * std::pow(dt, 5.2 + 0.05 * std::log2(dt)); };
  EXPECT_THAT(observed_order(curve(4, 0.5, 0.5, 6, steeper)).reason, HasSubstr("pre-asymptotic"));
}

TEST(observed_order, a_lost_order_fails) {
  const auto third = [](double dt) { return 0.1 * std::pow(dt, 3); };
  const auto order = observed_order(curve(4, 0.5, 0.5, 9, third));
  EXPECT_EQ(order.verdict, OrderVerdict::fails);
  EXPECT_THAT(order.reason, HasSubstr("below"));
  EXPECT_EQ(observed_order(curve(4, 0.5, 0.5, 9, third), {.slack = 1.1}).verdict, OrderVerdict::holds);
}

TEST(observed_order, growing_round_off_is_no_order) {
  const auto mostly_noise = [](double dt) { return fourth(dt) + 1e-11 / dt; };
  const auto order = observed_order(curve(4, 0.5, 0.5, 20, mostly_noise));
  EXPECT_EQ(order.verdict, OrderVerdict::holds);
  EXPECT_GT(order.dt_min.value(), 0.01);
  EXPECT_EQ(observed_order(curve(4, 0.5, 0.5, 9, [](double dt) { return 1e-6 / dt; })).verdict,
            OrderVerdict::inconclusive);
}

TEST(observed_order, failed_runs_are_gaps) {
  auto rows = curve(4, 0.5, 0.5, 9, fourth);
  rows[0].errors.reset(), rows[0].status = "not_finite";
  rows[4].errors->scaled = nan;
  rows[5].status = "time_limit";  // its error is not that of the end
  const auto order = observed_order(rows);
  EXPECT_EQ(order.verdict, OrderVerdict::holds);
  EXPECT_EQ(order.gaps, 3);
  EXPECT_EQ(order.points, 6);
}

TEST(observed_order, nothing_measured_is_never_a_pass) {
  EXPECT_EQ(observed_order({}).verdict, OrderVerdict::inconclusive);
  const auto all_nan = observed_order(curve(4, 0.5, 0.5, 9, [](double) { return nan; }));
  EXPECT_EQ(all_nan.verdict, OrderVerdict::inconclusive);
  EXPECT_FALSE(all_nan.slope);
  EXPECT_THAT(all_nan.reason, HasSubstr("9 runs gave no error"));
  EXPECT_EQ(observed_order(curve(4, 0.5, 0.5, 9, [](double) { return 0.0; })).verdict,
            OrderVerdict::inconclusive);
  EXPECT_EQ(judge_order(nan, 4, 0.3), OrderVerdict::inconclusive);
}

TEST(observed_order, high_orders_are_not_measurable_in_float) {
  const auto eighth = [](double dt) { return 0.5 * std::pow(dt, 8) + 1e-7; };
  const auto order = observed_order(curve(8, 1, 0.5, 10, eighth, "float"));
  EXPECT_EQ(order.verdict, OrderVerdict::inconclusive);
  EXPECT_FALSE(order.slope);
  EXPECT_THAT(order.reason, HasSubstr("not measurable in float: 1 usable rungs"));
  const auto second = [](double dt) { return 0.5 * std::pow(dt, 2) + 1e-7; };
  EXPECT_EQ(observed_order(curve(2, 1, 0.5, 12, second, "float")).verdict, OrderVerdict::holds);
}

TEST(observed_order, three_usable_rungs_count_only_if_they_agree) {
  const auto error = [](double dt) { return 0.05 * std::pow(dt, 10); };
  EXPECT_EQ(observed_order(curve(10, 1, 0.5, 8, error)).points, 4);
  auto rows = curve(10, 1, 0.5, 3, error);
  EXPECT_EQ(observed_order(rows).verdict, OrderVerdict::holds);
  rows[1].errors->scaled *= 2;
  const auto scattered = observed_order(rows);
  EXPECT_EQ(scattered.verdict, OrderVerdict::inconclusive);
  EXPECT_THAT(scattered.reason, HasSubstr("slopes that agree"));
  rows.pop_back();
  EXPECT_EQ(observed_order(rows).verdict, OrderVerdict::inconclusive);
}

TEST(observed_order, curves_are_told_apart) {
  auto rows = curve(4, 0.5, 0.5, 9, fourth);
  auto other = curve(4, 0.5, 0.5, 9, fourth, "float");
  for (Row& row : other) row.compensated = true;
  rows.insert(rows.begin() + 3, other.begin(), other.end());
  rows.push_back({});  // an adaptive run has no steps
  const auto orders = observed_orders(rows);
  ASSERT_EQ(orders.size(), 2u);
  EXPECT_EQ(case_name(orders[0].id), "kepler/rk4");
  EXPECT_EQ(case_name(orders[1].id), "kepler/rk4 [float, compensated]");
}

TEST(roundoff_onset, is_where_the_error_leaves_the_order_line_by_two) {
  // twice the line where 0.5 dt^4 = 1e-13 / dt
  const auto error = [](double dt) { return fourth(dt) + 1e-13 / dt; };
  const auto onset = roundoff_onset(observed_order(curve(4, 0.5, 0.5, 16, error)));
  EXPECT_NEAR(std::log2(onset.dt.value() / std::pow(2e-13, 0.2)), 0, 0.3);
  EXPECT_FALSE(onset.beyond_ladder);
  EXPECT_NEAR(onset.dt_at_minimum.value(), 1.0 / 512, 1e-6);
  EXPECT_TRUE(onset.reason.empty());
}

TEST(roundoff_onset, is_absent_where_smaller_steps_still_help) {
  const auto onset = roundoff_onset(observed_order(curve(4, 0.5, 0.5, 7, fourth)));
  EXPECT_FALSE(onset.dt);
  EXPECT_TRUE(onset.beyond_ladder);
  EXPECT_NEAR(onset.error_minimum.value(), fourth(0.5 / 64), 1e-18);
}

TEST(roundoff_onset, without_an_order_line_is_the_step_of_the_smallest_error) {
  const auto error = [](double dt) { return std::pow(dt, 20) + 1e-15 / dt; };
  const auto onset = roundoff_onset(observed_order(curve(20, 0.5, 0.5, 8, error)));
  EXPECT_NEAR(onset.dt.value(), 0.125, 1e-9);
  EXPECT_THAT(onset.reason, HasSubstr("no order line"));
  EXPECT_FALSE(roundoff_onset(observed_order({})).dt);
}

}  // namespace
}  // namespace odemark::observed_order_test
