// The report's analyses on rows with known answers, and that nothing is lost or invented on the way to the
// page.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <string>
#include <vector>

#include "reports/cheapest.hpp"
#include "reports/conservation.hpp"
#include "reports/console_summary.hpp"
#include "reports/convergence.hpp"
#include "reports/csv_rows.hpp"
#include "reports/failures.hpp"
#include "reports/page_files.hpp"
#include "reports/precision.hpp"
#include "reports/report_page.hpp"
#include "reports/stability_page.hpp"
#include "reports/work_precision.hpp"

namespace odemark {
namespace {

/// One run with `error` = constant * dt^order on a ladder of halved steps.
Row fixed_row(const std::string& problem, const std::string& method, int order, long steps, double error) {
  Row row;
  row.plan = "convergence", row.problem = problem, row.family = problem, row.method = method;
  row.kind = "explicit Runge-Kutta", row.provider = "odemark", row.scalar = "double";
  row.order = order, row.steps = steps, row.dt = 10.0 / static_cast<double>(steps),
  row.t_end = row.t_reached = 10;
  row.id = "convergence/" + problem + "/" + method + "/double/steps=" + std::to_string(steps);
  row.status = "reached_end", row.accepted = steps, row.work.evaluations = row.work.rhs = steps * order;
  row.errors = RowErrors{};
  row.errors->scaled = error;
  row.truth_floor = 1e-25;
  return row;
}

std::vector<Row> ladder(const std::string& problem, const std::string& method, int order) {
  std::vector<Row> rows;
  for (long steps = 16; steps <= 4096; steps *= 2)
    rows.push_back(fixed_row(problem, method, order, steps, 0.1 * std::pow(10.0 / double(steps), order)));
  return rows;
}

void append(std::vector<Row>& rows, const std::vector<Row>& more) {
  rows.insert(rows.end(), more.begin(), more.end());
}

Row failed_row(const std::string& problem, const std::string& method, long steps, const std::string& status) {
  Row row = fixed_row(problem, method, 1, steps, 0);
  row.errors.reset();
  row.status = status, row.reason = "y[0] is not finite", row.t_reached = 2.5;
  return row;
}

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

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

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

TEST(Convergence, FloorIsDrawnAndDivergedRunsStandOnTheFrame) {
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

TEST(Convergence, CountsAndMatrix) {
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

StabilityRow limit_row(double measured, double theory) {
  StabilityRow row;
  row.problem = "p", row.method = "rk4", row.verdict = row.theory_verdict = "limit";
  row.measured = measured, row.theory = theory, row.difference = measured - theory;
  row.resolution = 1e-9, row.fastest_rate = 1;
  return row;
}

TEST(StabilityPage, DisagreementsAreListed) {
  const std::vector<StabilityRow> rows{limit_row(2.785, 2.785), limit_row(2.5, 2.785)};
  EXPECT_EQ(count_stability(rows).agrees, 1);
  EXPECT_EQ(disagreeing_limits(rows).rows.size(), 1u);
}

ReportInput small_report() {
  ReportInput input;
  input.header.suite = "quick", input.header.version = "0.1.0",
  input.header.footnotes = {"GSL was built slow"};
  for (const char* problem : {"oscillator", "pendulum"})
    for (const char* method : {"rk4", "dormand_prince54"}) append(input.rows, ladder(problem, method, 4));
  for (Row& row : input.rows) row.drift["energy"] = 1e-6;
  input.rows.push_back(failed_row("pendulum", "explicit_euler", 16, "not_finite"));
  input.stability = {limit_row(2.785, 2.785)};
  return input;
}

TEST(ReportPage, NamesEveryProblemMethodStatusAndFootnote) {
  const std::string html = to_html(report_page(small_report()));
  for (const char* text : {"oscillator", "pendulum", "rk4", "dormand_prince54", "not_finite",
                           "GSL was built slow", "y[0] is not finite", "round-off"})
    EXPECT_NE(html.find(text), std::string::npos) << text;
  EXPECT_EQ(html.find("nan"), std::string::npos);
}

TEST(ReportPage, IsDeterministic) {
  const ReportInput input = small_report();
  EXPECT_EQ(to_html(report_page(input)), to_html(report_page(input)));
  EXPECT_EQ(to_markdown(report_page(input), "svg"), to_markdown(report_page(input), "svg"));
}

TEST(ReportPage, FilesHaveUniqueNames) {
  const auto files = page_files(report_page(small_report()), "svg", "csv");
  std::set<std::string> names;
  for (const auto& file : files) EXPECT_TRUE(names.insert(file.name).second) << file.name;
  EXPECT_TRUE(names.contains("svg/pendulum-dt.svg"));
  EXPECT_TRUE(names.contains("csv/cheapest-evaluations.csv"));
}

TEST(ReportPage, ManyProblemsHaveTheirChartsOnPagesOfTheirOwn) {
  ReportInput input;
  for (std::size_t i = 0; i <= problems_on_one_page; ++i)
    append(input.rows, ladder("problem" + std::to_string(i), "rk4", 4));
  const auto names = [](const Page& page) {
    std::set<std::string> all;
    for (const auto& file : page_files(page, "svg", "csv")) all.insert(file.name);
    return all;
  };
  EXPECT_FALSE(names(report_page(input)).contains("svg/problem3-dt.svg"));
  EXPECT_NE(to_html(report_page(input)).find("problems/problem3.html"), std::string::npos);
  const auto pages = problem_pages(input);
  ASSERT_EQ(pages.size(), problems_on_one_page + 1);
  EXPECT_EQ(pages[3].name, "problems/problem3.html");
  EXPECT_TRUE(names(pages[3].page).contains("svg/problem3-dt.svg"));
  EXPECT_TRUE(names(pages[3].page).contains("svg/problem3-dt-all.svg"));
}

TEST(ReportPage, SurvivesNothingOnlyFailuresAndASingleRow) {
  EXPECT_EQ(report_page({}).verdict->status, Status::warn);
  ReportInput failures;
  failures.rows = {failed_row("p", "m", 16, "not_finite"), failed_row("p", "n", 16, "not_applicable")};
  EXPECT_NE(to_html(report_page(failures)).find("not_finite"), std::string::npos);
  ReportInput single;
  single.rows = {fixed_row("p", "m", 1, 16, 0.1)};
  EXPECT_FALSE(to_html(report_page(single)).empty());
  single.rows[0].errors.reset();  // no truth
  single.rows[0].reason = "no error: the two computations share 3 digits";
  EXPECT_NE(to_html(report_page(single)).find("share 3 digits"), std::string::npos);
  for (const auto* input : {&failures, &single})
    EXPECT_FALSE(console_summary(input->rows, input->stability).empty());
  EXPECT_FALSE(console_summary({}, {}).empty());
}

TEST(ConsoleSummary, IsAboutADozenLines) {
  std::vector<Row> rows;
  for (int i = 0; i < 14; ++i) append(rows, ladder("problem" + std::to_string(i), "rk4", 4));
  const std::string text = console_summary(rows, {});
  const auto lines = std::count(text.begin(), text.end(), '\n');
  EXPECT_GE(lines, 12);
  EXPECT_LE(lines, 18);
  EXPECT_NE(text.find("14 hold"), std::string::npos);
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
}  // namespace odemark
