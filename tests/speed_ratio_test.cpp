// Ratios of our best to the best of the others: interpolated by hand, never extrapolated, blanks with
// reasons.
#include "reports/speed_ratio.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace odemark::speed_ratio_test {
namespace {

using testing::HasSubstr;

Row timed(const std::string& method, const std::string& provider, double tolerance, double error,
          double seconds) {
  Row row;
  row.problem = "p", row.method = method, row.provider = provider, row.kind = "explicit Runge-Kutta";
  row.scalar = "double", row.rtol = tolerance, row.status = "reached_end", row.t_end = 1,
  row.truth_floor = 1e-30;
  row.errors = RowErrors{};
  row.errors->scaled = error;
  row.timing = RowTiming{};
  row.timing->ns_per_simulated_second = 1e9 * seconds, row.timing->tier = "erased";
  return row;
}

std::vector<Row> both_sides() {
  return {timed("own", "odemark", 1e-2, 1e-2, 1e-6),   timed("own", "odemark", 1e-4, 1e-4, 4e-6),
          timed("own", "odemark", 1e-10, 1e-10, 9e-6), timed("slow", "odemark", 1e-2, 1e-2, 1e-3),
          timed("slow", "odemark", 1e-4, 1e-4, 1e-3),  timed("theirs", "gsl", 1e-2, 1e-2, 2e-6),
          timed("theirs", "gsl", 1e-4, 1e-4, 8e-6)};
}

TEST(SpeedRatio, IsInterpolatedOnLogarithmicAxes) {
  const auto ratios = speed_ratios(work_curves(both_sides()));
  ASSERT_EQ(ratios.size(), std::size(ratio_errors));
  const auto& r = ratios[0];
  ASSERT_TRUE(r.own && r.other && r.ratio());
  EXPECT_EQ(r.own->method, "own");
  EXPECT_EQ(r.other->method, "theirs");
  EXPECT_NEAR(r.own->cost, 2000, 1e-6);  // half way between 1 and 4 us
  EXPECT_NEAR(r.other->cost, 4000, 1e-6);
  EXPECT_NEAR(*r.ratio(), 0.5, 1e-12);
}

TEST(SpeedRatio, NobodyIsExtrapolated) {
  const auto ratios = speed_ratios(work_curves(both_sides()));
  EXPECT_TRUE(ratios[1].own);
  EXPECT_FALSE(ratios[1].other);
  EXPECT_FALSE(ratios[1].ratio());
  EXPECT_THAT(ratios[1].other_reason, HasSubstr("nearest: theirs with 1e-04"));
  EXPECT_FALSE(ratios[3].own);
  EXPECT_THAT(ratios[3].own_reason, HasSubstr("nearest: own with 1e-10"));
  const Table table = speed_ratio_table(ratios);
  constexpr std::size_t ratio_column = 8;
  EXPECT_EQ(table.columns[ratio_column].name, "ratio");
  EXPECT_EQ(table.rows[0][ratio_column].text, "0.50");
  EXPECT_EQ(table.rows[1][ratio_column].text, "–");
}

TEST(SpeedRatio, SaysHowManyStoodOnEachSideAndWhatOneTakesWithoutLooking) {
  auto rows = both_sides();
  for (const double tolerance : {1e-2, 1e-4})
    rows.push_back(
        timed(std::string(everyday_methods[1]), "odemark", tolerance, tolerance, 300e-6 * tolerance));
  const auto ratios = speed_ratios(work_curves(rows));
  const auto& r = ratios[0];
  EXPECT_EQ(r.own_count, 3u);
  EXPECT_EQ(r.other_count, 1u);
  EXPECT_EQ(ratios[2].own_count, 1u);
  EXPECT_EQ(ratios[2].other_count, 0u);
  EXPECT_FALSE(r.everyday[0]);
  ASSERT_TRUE(r.everyday[1]);
  EXPECT_NEAR(r.everyday[1]->cost, 300, 1e-6);  // half way between 3000 and 30 ns
  const Table table = speed_ratio_table(ratios);
  ASSERT_EQ(table.columns.size(), 9 + std::size(everyday_methods));
  for (const auto& row : table.rows) EXPECT_EQ(row.size(), table.columns.size());
  EXPECT_EQ(table.rows[0][10].text, fmt::format("{:.2f}", r.everyday[1]->cost / r.other->cost));
  EXPECT_EQ(table.rows[0][9].text, "–");
}

TEST(SpeedRatio, FailuresAreReasonsAndUntimedProblemsAreLeftOut) {
  auto rows = both_sides();
  for (Row& row : rows)
    if (row.provider == "gsl") row.status = "time_limit", row.errors.reset(), row.timing.reset();
  const auto ratios = speed_ratios(work_curves(rows));
  EXPECT_THAT(ratios[0].other_reason, HasSubstr("none reached the end: time_limit"));
  for (Row& row : rows) row.timing.reset();
  EXPECT_TRUE(speed_ratios(work_curves(rows)).empty());
  EXPECT_FALSE(compares_codes(work_curves(rows)));
  EXPECT_TRUE(compares_codes(work_curves(both_sides())));
}

}  // namespace
}  // namespace odemark::speed_ratio_test
