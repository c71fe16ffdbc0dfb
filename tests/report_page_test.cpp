// The report as a whole: everything is on the page, the same input gives the same bytes, and odd results do
// not break it.
#include "reports/report_page.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "reports/console_summary.hpp"
#include "reports/page_files.hpp"
#include "tests/report_rows.hpp"

namespace odemark::report_page_test {
namespace {

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

TEST(ReportPage, FootnotesAreOfWhoIsThere) {
  ReportInput input = small_report();
  input.header.footnotes = {"cvode_bdf, rk4: half of them is here", "cvode_bdf, cvode_adams: nobody is here"};
  const std::string html = to_html(report_page(input));
  const auto count = [&](std::string_view words) {
    int found = 0;
    for (auto at = html.find(words); at != html.npos; at = html.find(words, at + 1)) ++found;
    return found;
  };
  EXPECT_EQ(count("half of them is here"), 2);  // at the top and where it says how it was measured
  EXPECT_EQ(count("nobody is here"), 1);
}

/// A motion that has died before the end makes any method look exact there.
TEST(ReportPage, ErrorsOfADyingMotionAreThoseOverTheWholeTime) {
  ReportInput input = small_report();
  for (Row& row : input.rows)
    if (row.errors) row.errors->scaled = 1e-25, row.errors->left = 1e-24, row.errors->trajectory_max = 0.25;
  const std::string html = to_html(report_page(input));
  EXPECT_NE(html.find("Next to nothing of the motion is left"), std::string::npos);
  EXPECT_EQ(html.find("25.0 |"), std::string::npos);
  EXPECT_NE(html.find("0.6 |"), std::string::npos);
  EXPECT_EQ(to_html(report_page(small_report())).find("Next to nothing"), std::string::npos);
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

TEST(PageTables, HtmlSaysHowManyRowsScroll) {
  Table table{"long", "Long", "", {{"of it"}, {""}}, {}};
  for (int i = 0; i < 12; ++i) table.rows.push_back({{"a"}, {"b"}});
  EXPECT_NE(to_html(table).find("<caption>Long</caption>"), std::string::npos);
  EXPECT_NE(to_html(table).find("<th scope=\"col\">of it</th><td></td></tr>"), std::string::npos)
      << "what heads nothing is no header";
  table.rows.push_back({{"a"}, {"b"}});
  EXPECT_NE(to_html(table).find("<caption>Long<span class=\"rows\">13 rows</span></caption>"),
            std::string::npos);
}

TEST(PageHtml, LongNamesInALegendMayBreak) {
  Chart chart{.id = "c", .title = "t", .caption = ""};
  chart.series.push_back({"rk4", "velocity_verlet_<x>", "", {{1, 1}, {2, 2}}});
  const std::string html = to_html(Page{.title = "t", .sections = {{"s", "S", {chart}}}});
  EXPECT_NE(html.find("<span>velocity_<wbr>verlet_<wbr>&lt;x&gt;</span></li>"), std::string::npos);
}

}  // namespace
}  // namespace odemark::report_page_test
