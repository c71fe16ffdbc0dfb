// Step-size control where stability holds the step down, and the pictures and tables made of chosen steps.
#include "bench/settling.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "integrators/facts.hpp"
#include "reports/settling.hpp"
#include "reports/step_sizes.hpp"
#include "tests/report_rows.hpp"

namespace odemark::settling_test {
namespace {

using testing::HasSubstr;

const std::vector<Settling>& measured() {
  static const std::vector<Settling> all = [] {
    std::vector<AnyMethod> methods;
    for (const AnyMethod& m : suite_methods())
      for (const auto id : {"bogacki_shampine32", "dormand_prince54", "tsitouras54", "bogacki_shampine54",
                            "rk4", "rodas4", "gragg_bulirsch_stoer"})
        if (m.id == id) methods.push_back(m);
    return measure_settling(methods);
  }();
  return all;
}

const Settling& find(std::string_view method, std::string_view filter) {
  return *std::find_if(measured().begin(), measured().end(),
                       [&](const Settling& s) { return s.method == method && s.filter == filter; });
}

TEST(Settling, JudgesExplicitMethodsWithAnEstimateUnderEveryFilter) {
  EXPECT_EQ(measured().size(), 4 * step_filters.size());
  for (const Settling& s : measured()) {
    EXPECT_EQ(s.status, "reached_end") << s.method << "/" << s.filter;
    EXPECT_GT(s.accepted, 500) << s.method << "/" << s.filter;
  }
}

TEST(Settling, ProportionalIntegralControlRestsOnTheLimit) {
  const std::pair<std::string_view, double> known[] = {
      {"dormand_prince54", 3.3063}, {"bogacki_shampine32", 2.5127}, {"tsitouras54", 3.5066}};
  for (const auto& [method, mean] : known) {
    const Settling& s = find(method, "pi");
    EXPECT_NEAR(s.mean, mean, 5e-4) << method;
    EXPECT_NEAR(s.mean / s.limit, 1, 2e-4) << method;
    EXPECT_TRUE(settles(s)) << method << " scatter " << s.scatter << ", rejected " << s.rejected;
  }
}

/// The step-size recursion at the boundary, from the coefficients, says who comes to rest. The pair of
/// Bogacki and Shampine with the estimate of all eight stages is unstable there under `pi` and stable under
/// `h211b`; the others are the other way round.
TEST(Settling, WhoRestsIsWhatTheCoefficientsSay) {
  for (const auto method : {"dormand_prince54", "tsitouras54", "bogacki_shampine54", "bogacki_shampine32"}) {
    const auto& all = suite_methods();
    const AnyMethod& m =
        *std::find_if(all.begin(), all.end(), [&](const AnyMethod& any) { return any.id == method; });
    const auto radii = method_facts(m.theory(), m.order, m.embedded_order).controller_spectral_radius;
    ASSERT_TRUE(radii) << method << ": " << radii.reason;
    for (const auto filter : {"elementary", "pi"}) {
      const double radius = double(radii->at(filter));
      const Settling& s = find(method, filter);
      if (radius < 0.95) {
        EXPECT_TRUE(settles(s)) << method << "/" << filter << " radius " << radius << " scatter "
                                << s.scatter;
      }
      if (radius > 1.02) {
        EXPECT_FALSE(settles(s)) << method << "/" << filter << " radius " << radius << " scatter "
                                 << s.scatter;
      }
    }
  }
}

TEST(Settling, TableAndSentenceSayWhatWasMeasured) {
  const std::vector<Settling> all{{"a", "pi", "reached_end", 2, 2, 1e-5, 1000, 1},
                                  {"a", "none", "reached_end", 2, 1.5, 0.2, 1000, 500},
                                  {"b", "pi", "reached_end", 4, 4, 1e-5, 1000, 1},
                                  {"b", "none", "step_limit", 4, 0, 0, 9, 9}};
  EXPECT_THAT(settling_answer(all), HasSubstr("Of 2 explicit methods"));
  EXPECT_THAT(settling_answer(all), HasSubstr("2 under pi, 0 under none"));
  EXPECT_EQ(settling_answer({}), "");
  const Table table = settling_table(all);
  ASSERT_EQ(table.rows.size(), 2u);
  for (const auto& row : table.rows) EXPECT_EQ(row.size(), table.columns.size());
  EXPECT_EQ(table.rows[0][2].text, "1.0000");
  EXPECT_EQ(table.rows[0][2].status, Status::ok);
  EXPECT_EQ(table.rows[0][5].text, "0.7500");
  EXPECT_EQ(table.rows[0][5].status, Status::plain);
  EXPECT_EQ(table.rows[0][7].text, "33.3 %");
  EXPECT_EQ(table.rows[1][5].text, "step_limit");
  EXPECT_FALSE(settles(all[1]));
  EXPECT_FALSE(settles(all[3]));
}

Row with_steps(const std::string& method, double tolerance, double step) {
  Row row = fixed_row("p", method, 5, 16, 1e-6);
  row.steps.reset(), row.dt.reset();
  row.rtol = tolerance;
  row.history = RowSteps{{0, 0.5}, {step, 2 * step}};
  return row;
}

TEST(StepSizes, AreDrawnAtTheToleranceNearestToAMillionth) {
  const Palette palette({{"dormand_prince54", "e"}, {"verner87", "e"}, {"rodas5p", "r"}, {"else", "e"}});
  std::vector<Row> rows{with_steps("dormand_prince54", 1e-3, 0.1), with_steps("dormand_prince54", 1e-7, 0.01),
                        with_steps("verner87", 1e-7, 0.04), with_steps("else", 1e-7, 1),
                        with_steps("rodas5p", 1e-7, 1)};
  rows.back().status = "step_limit";
  const Chart chart = step_size_chart(rows, "p", palette);
  ASSERT_EQ(chart.series.size(), 2u);
  EXPECT_EQ(chart.series[0].id, "dormand_prince54");
  ASSERT_EQ(chart.series[0].points.size(), 2u);
  EXPECT_EQ(chart.series[0].points[1].x, 0.5);
  EXPECT_EQ(chart.series[0].points[1].y, 0.02);
  EXPECT_EQ(chart.series[1].points[0].y, 0.04);
  EXPECT_EQ(chart.x.label, "t");
  EXPECT_EQ(step_size_chart(rows, "p", palette, "s").x.label, "t [s]");
  EXPECT_EQ(step_size_chart(rows, "p", palette, "s").y.label, "h [s]");
  EXPECT_TRUE(step_size_chart(rows, "q", palette).series.empty());
  rows[1].history.reset(), rows[2].history.reset();
  EXPECT_TRUE(step_size_chart({rows[1], rows[2]}, "p", palette).series.empty());
}

}  // namespace
}  // namespace odemark::settling_test
