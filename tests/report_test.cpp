// The report's analyses on rows with known answers: nothing is lost, nothing is invented.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "reports/cheapest.hpp"
#include "reports/conservation.hpp"
#include "reports/convergence.hpp"
#include "reports/csv_rows.hpp"
#include "reports/failures.hpp"
#include "reports/precision.hpp"
#include "reports/stability_page.hpp"
#include "reports/work_precision.hpp"
#include "tests/report_rows.hpp"

namespace odemark::report_test {
namespace {

bool mentions(const Table& table, const std::string& text) {
  for (const auto& row : table.rows)
    for (const auto& cell : row)
      if (cell.text.find(text) != std::string::npos) return true;
  return false;
}

WorkCurve curve_of_errors(const std::vector<double>& errors) {
  WorkCurve curve;
  curve.problem = "p", curve.method = curve.label = "m";
  double evaluations = 100;
  for (const double error : errors) {
    CurvePoint p;
    p.control = 1 / evaluations, p.error = error, p.evaluations = evaluations, p.failed = std::isnan(error);
    p.time = std::numeric_limits<double>::quiet_NaN(), p.floor = 1e-16;
    curve.points.push_back(p);
    evaluations *= 10;
  }
  return curve;
}

TEST(Cheapest, InterpolatesOnLogarithmicAxes) {
  const auto offer = offer_of(curve_of_errors({1e-2, 1e-4, 1e-6}), 1e-3, Cost::evaluations);
  ASSERT_TRUE(offer);
  EXPECT_NEAR(offer->cost, 100 * std::sqrt(10.0), 1e-9);
  EXPECT_FALSE(offer->at_most);
}

TEST(Cheapest, NeverExtrapolates) {
  const WorkCurve curve = curve_of_errors({1e-2, 1e-4, 1e-6});
  EXPECT_FALSE(offer_of(curve, 1e-7, Cost::evaluations));
  const auto coarse = offer_of(curve, 1e-1, Cost::evaluations);
  ASSERT_TRUE(coarse);
  EXPECT_EQ(coarse->cost, 100);  // what was run, not less
  EXPECT_TRUE(coarse->at_most);
}

TEST(Cheapest, LuckyCrossingWinsNothing) {
  const auto offer = offer_of(curve_of_errors({1e-7, 1e-2, 1e-4, 1e-9}), 1e-6, Cost::evaluations);
  ASSERT_TRUE(offer);
  EXPECT_GT(offer->cost, 10'000);
}

TEST(Cheapest, AfterAFailureTheNextRunCountsAsItIs) {
  const auto offer = offer_of(curve_of_errors({nan, 1e-4, 1e-6}), 1e-3, Cost::evaluations);
  ASSERT_TRUE(offer);
  EXPECT_EQ(offer->cost, 1000);
  EXPECT_TRUE(offer->at_most);
}

TEST(Cheapest, NothingBelowTheFloorAndNothingUntimed) {
  WorkCurve curve = curve_of_errors({1e-2, 1e-12});
  curve.points.back().floor = 1e-8;
  EXPECT_FALSE(offer_of(curve, 1e-9, Cost::evaluations));
  EXPECT_TRUE(offer_of(curve, 1e-7, Cost::evaluations));
  EXPECT_FALSE(offer_of(curve, 1e-7, Cost::time));
  EXPECT_FALSE(offer_of(curve_of_errors({nan, nan}), 1e-2, Cost::evaluations));
}

TEST(Cheapest, OneOfferPerMethod) {
  ProblemCurves problem{"p", 0, false, {curve_of_errors({1e-2, 1e-4}), curve_of_errors({1e-1, 1e-4})}};
  EXPECT_EQ(cheapest(problem, 1e-3, Cost::evaluations).size(), 1u);
}

TEST(WorkCurves, FailuresStayAndNotApplicableDoesNot) {
  std::vector<Row> rows{failed_row("p", "m", 16, "not_finite"), fixed_row("p", "m", 1, 32, 0.1)};
  rows.push_back(failed_row("p", "other", 16, "not_applicable"));
  const auto problems = work_curves(rows);
  ASSERT_EQ(problems.size(), 1u);
  ASSERT_EQ(problems[0].curves.size(), 1u);
  const auto& points = problems[0].curves[0].points;
  ASSERT_EQ(points.size(), 2u);
  EXPECT_TRUE(points[0].failed);
  EXPECT_TRUE(std::isnan(points[0].error));
  EXPECT_EQ(points[0].status, "not_finite");
}

TEST(WorkCurves, BestOfFamilyIsOnePerFamilyAndTheFourThatEverybodyKnows) {
  std::vector<Row> rows;
  for (int order = 2; order <= 12; ++order) {
    auto taylor = ladder("p", "taylor" + std::to_string(order), order);
    for (Row& row : taylor) row.kind = "Taylor series";
    append(rows, taylor);
  }
  append(rows, ladder("p", "rk4", 4));
  append(rows, ladder("p", "explicit_euler", 1));
  append(rows, ladder("p", "unknown_midpoint", 2));
  const auto problems = work_curves(rows);
  const auto shown = best_of_family(problems[0], true);
  EXPECT_EQ(shown.size(), 3u);  // one Taylor order, rk4 (twice over), explicit_euler
  for (const auto i : shown) EXPECT_NE(problems[0].curves[i].method, "unknown_midpoint");
}

TEST(WorkPrecision, TheCaptionSaysWhatTheLinesAre) {
  std::vector<PaletteMember> members;
  for (int i = 0; i < 10; ++i) members.push_back({"m" + std::to_string(i), "family" + std::to_string(i)});
  members.push_back({"m", "the eleventh"});  // the palette draws it dashed
  members.push_back({"rk4", "family0"});
  const Palette palette(members);
  ProblemCurves problem{"p", 0, false, {curve_of_errors({1e-2, 1e-4, 1e-8})}};
  problem.curves[0].family = "the eleventh";
  const auto caption = [&] { return error_by_cost(problem, palette, Cost::evaluations).caption; };
  EXPECT_EQ(caption().find("Dashed"), std::string::npos) << caption();
  EXPECT_NE(caption().find("Dotted: fixed steps"), std::string::npos) << caption();
  WorkCurve other = curve_of_errors({1e-2, 1e-4, 1e-8});
  other.method = other.label = "rk4", other.family = "family0", other.adaptive = true;
  problem.curves = {other};
  EXPECT_NE(caption().find("Dashed: the method chooses its own steps."), std::string::npos) << caption();
  EXPECT_EQ(caption().find("Dotted"), std::string::npos) << caption();
}

TEST(ReportConvergence, FloorIsDrawnAndDivergedRunsStandOnTheFrame) {
  auto rows = ladder("p", "rk4", 4);
  for (Row& row : rows) row.truth_floor = 1e-9;
  rows.push_back(failed_row("p", "rk4", 8, "not_finite"));
  const auto problems = work_curves(rows);
  const Chart chart = error_by_dt(problems[0], report_palette({}, rows), Shown::best_of_family, {}, nullptr);
  ASSERT_EQ(chart.bands.size(), 1u);
  EXPECT_EQ(chart.bands[0].high, 1e-9);
  ASSERT_EQ(chart.series.size(), 1u);
  EXPECT_TRUE(chart.series[0].points.front().diverged);
}

TEST(ReportConvergence, CountsAndMatrix) {
  auto rows = ladder("p", "rk4", 4);
  append(rows, ladder("p", "heun", 2));
  for (Row& row : rows)
    if (row.method == "heun") row.order = 4;  // claims too much
  const auto orders = observed_orders(rows);
  const OrderCounts counts = count_orders(orders);
  EXPECT_EQ(counts.holds, 1);
  EXPECT_EQ(counts.fails, 1);
  EXPECT_EQ(counts.total(), 2);
  EXPECT_TRUE(mentions(order_matrix(orders), "4.00"));
  EXPECT_TRUE(mentions(failed_orders(orders, {}), "p/heun"));
  EXPECT_FALSE(mentions(failed_orders(orders, {}), "p/rk4"));
}

TEST(Failures, EveryFailedRunIsCountedWithItsReason) {
  std::vector<Row> rows = ladder("p", "m", 1);
  for (const long steps : {2, 4, 8}) rows.push_back(failed_row("p", "m", steps, "not_finite"));
  rows.push_back(failed_row("p", "m", 9, "time_limit"));
  const Table table = failure_table(rows);
  ASSERT_EQ(table.rows.size(), 2u);
  EXPECT_EQ(table.rows[0][2].text, "3 of 13");
  EXPECT_TRUE(mentions(table, "y[0] is not finite"));
  EXPECT_EQ(failures_by_status(rows).at("not_finite"), 3);
}

TEST(Precision, SaysWhenRoundoffWasNotReached) {
  auto rows = ladder("p", "explicit_euler", 1);
  auto single = rows;
  for (Row& row : single) {
    row.scalar = "float", row.plan = "precision";
    if (*row.steps > 512) row.errors->scaled = 1e-4 * double(*row.steps);
  }
  append(rows, single);
  const auto orders = precision_orders(rows);
  const Table table = roundoff_table(orders, "p");
  ASSERT_EQ(table.columns.size(), 3u);
  EXPECT_TRUE(mentions(table, "not reached"));
  EXPECT_EQ(precision_problems(orders), std::vector<std::string>{"p"});
  EXPECT_TRUE(precision_orders(ladder("q", "rk4", 4)).empty());  // one number type: nothing to compare
}

TEST(Conservation, NaNIsNeverTheLeastDrift) {
  std::vector<Row> rows{fixed_row("p", "good", 1, 100, 0.1), fixed_row("p", "bad", 1, 100, 0.1)};
  rows[0].drift["energy"] = 1e-3, rows[1].drift["energy"] = nan;
  const Table table = drift_table(rows, "p", 0.1);
  ASSERT_EQ(table.rows.size(), 2u);
  EXPECT_EQ(table.rows[0][0].text, "good");
  EXPECT_NE(drift_answer(rows, "p", 0.1).find("(good)"), std::string::npos);
}

TEST(StabilityPage, DisagreementsAreListed) {
  const std::vector<StabilityRow> rows{limit_row(2.785, 2.785), limit_row(2.5, 2.785)};
  EXPECT_EQ(count_stability(rows).agrees, 1);
  EXPECT_EQ(disagreeing_limits(rows).rows.size(), 1u);
}

TEST(CsvRows, EveryRunHasALineAndAbsentIsEmpty) {
  const std::vector<Row> rows{fixed_row("p", "m", 1, 16, 0.1), failed_row("p", "m", 32, "not_finite")};
  const Table table = rows_table(rows);
  ASSERT_EQ(table.rows.size(), 2u);
  for (const auto& row : table.rows) EXPECT_EQ(row.size(), table.columns.size());
  const std::string csv = to_csv(table);
  EXPECT_EQ(csv.find("nan"), std::string::npos);
  EXPECT_NE(csv.find("not_finite"), std::string::npos);
}

}  // namespace
}  // namespace odemark::report_test
