// The texts of a check read back as what they say, whatever is in the names; and results files side by side.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>
#include <limits>
#include <nlohmann/json.hpp>
#include <sstream>

#include "check_rows.hpp"
#include "reports/annotations.hpp"
#include "reports/compare.hpp"
#include "reports/junit.hpp"

namespace odemark::check_texts_test {
namespace {

using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

/// One finding of every outcome, with names that need escaping.
CheckResult every_outcome() {
  CheckResult result;
  result.thresholds_name = "thresholds.toml", result.baseline_name = "baseline.json";
  result.executed = 9, result.compared = 7, result.not_applicable = 3;
  int line = 10;
  for (const Outcome outcome : {Outcome::pass, Outcome::note, Outcome::improved, Outcome::skipped,
                                Outcome::missing, Outcome::no_reference, Outcome::fail}) {
    Finding finding;
    finding.case_name = "a<b&\"c\"|%/rk4", finding.problem = "a<b&\"c\"|%", finding.method = "rk4";
    finding.metric = "error", finding.outcome = outcome, finding.line = line++, finding.others = 1;
    finding.message = "1 > 0,5: 100 %\n]]> 'x' \x01";
    result.findings.push_back(finding);
  }
  return result;
}

TEST(junit, reads_back_with_one_test_case_per_finding) {
  std::istringstream text(to_junit(every_outcome()));
  boost::property_tree::ptree tree;
  boost::property_tree::read_xml(text, tree);
  const auto& suite = tree.get_child("testsuites.testsuite");
  EXPECT_EQ(suite.get<int>("<xmlattr>.tests"), 7);
  EXPECT_EQ(suite.get<int>("<xmlattr>.failures"), 1);
  EXPECT_EQ(suite.get<int>("<xmlattr>.errors"), 2);
  EXPECT_EQ(suite.get<int>("<xmlattr>.skipped"), 1);
  EXPECT_EQ(suite.count("testcase"), 7u);
  std::map<std::string, int> inside;
  for (const auto& [name, child] : suite) {
    if (name != "testcase") continue;
    EXPECT_EQ(child.get<std::string>("<xmlattr>.classname"), "error.a<b&\"c\"|%");
    EXPECT_EQ(child.get<std::string>("<xmlattr>.name"), "rk4");
    for (const auto& [what, ignored] : child)
      if (what != "<xmlattr>") ++inside[what];
  }
  EXPECT_EQ(inside["failure"], 1);
  EXPECT_EQ(inside["error"], 2);
  EXPECT_EQ(inside["skipped"], 1);
  EXPECT_EQ(inside["system-out"], 3);
}

TEST(junit, nothing_compared_is_an_error) {
  EXPECT_THAT(to_junit({}), HasSubstr("<error message=\"no case was compared\"/>"));
}

TEST(check_json, reads_back) {
  const auto j = nlohmann::json::parse(to_json(every_outcome()));
  EXPECT_EQ(j.at("exit_code"), 1);
  EXPECT_EQ(j.at("cases").at("compared"), 7);
  EXPECT_EQ(j.at("counts").at("fail"), 1);
  ASSERT_EQ(j.at("findings").size(), 7u);
  EXPECT_EQ(j.at("findings")[6].at("case"), "a<b&\"c\"|%/rk4");
  EXPECT_EQ(j.at("findings")[6].at("line"), 16);
}

TEST(check_console, says_what_was_compared_and_how_it_ends) {
  const std::string text = to_console(every_outcome());
  EXPECT_THAT(text, StartsWith("compared 7 of 9 cases against thresholds.toml, baseline.json"));
  EXPECT_THAT(text, HasSubstr("3 more are not applicable"));
  EXPECT_THAT(text, HasSubstr("thresholds.toml:16\n"));
  EXPECT_THAT(text, HasSubstr("(and 1 more)"));
  EXPECT_THAT(text, testing::EndsWith("1 failed, 1 passed, 1 note, 1 improved, 1 skipped, 1 missing, 1 no "
                                      "reference  exit 1\n"));
  EXPECT_LT(text.find("FAIL "), text.find("MISSING"));
  EXPECT_THAT(to_console({}), HasSubstr("compared 0 of 0 cases"));
  const std::string nothing = to_console(gate(good_rows(), ""));
  EXPECT_THAT(nothing, HasSubstr("compared 0 of 4 cases"));
  EXPECT_THAT(nothing, HasSubstr("nothing was compared: neither thresholds.toml nor"));
  EXPECT_THAT(nothing, testing::EndsWith("0 failed, 0 passed  exit 3\n"));
}

TEST(check_markdown, puts_failures_first_and_ends_in_time) {
  auto result = every_outcome();
  const std::string text = to_markdown(result);
  EXPECT_THAT(text, StartsWith("<!-- odemark check -->\n## odemark check: FAILED\n"));
  EXPECT_THAT(text, HasSubstr("a&lt;b&amp;\"c\"\\|%/rk4"));
  EXPECT_LT(text.find("1 failed\n"), text.find("1 improved\n"));
  EXPECT_THAT(to_markdown(gate(good_rows(), "[[rule]]\ncase = \"*/rk4\"\norder = \"claimed\"")),
              HasSubstr("## odemark check: passed"));
  for (int i = 0; i < 16; ++i) {  // 7 * 2^16 findings would be 50 MB
    const auto half = result.findings;
    if (half.size() < 20'000) result.findings.insert(result.findings.end(), half.begin(), half.end());
  }
  const std::string capped = to_markdown(result);
  EXPECT_LT(capped.size(), 900'000u);
  EXPECT_THAT(capped, HasSubstr("more lines left out"));
}

TEST(annotations, point_at_the_line_and_cannot_be_broken_out_of) {
  const std::string text = to_github(every_outcome(), "ci/thresholds.toml");
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 4);
  EXPECT_THAT(text, StartsWith("::error file=ci/thresholds.toml,line=16,title=a<b&\"c\"|%25/rk4 error::"));
  EXPECT_THAT(text, HasSubstr("1 > 0,5: 100 %25%0A]]>"));
  EXPECT_THAT(text, HasSubstr("::notice file=ci/thresholds.toml,line=12,"));
  EXPECT_EQ(to_github(gate(good_rows(), "[[rule]]\ncase = \"*/rk4\"\norder = \"claimed\"")), "");
}

std::string cell_of(const Table& table, const std::string& row, const std::string& column) {
  for (std::size_t c = 0; c < table.columns.size(); ++c)
    if (table.columns[c].name == column)
      for (const auto& cells : table.rows)
        if (cells.at(0).text == row) return cells.at(c).text;
  return "none";
}

RowTiming timing(double median, double mad) {
  RowTiming t;
  t.median_seconds = median, t.mad_seconds = mad, t.repeats = 9;
  return t;
}

TEST(compare, one_word_per_run) {
  const auto before = good_rows();
  auto now = before;
  run_of(now, "kepler", "rk4", 16).errors->scaled *= 2;
  run_of(now, "kepler", "rk4", 32).errors->scaled /= 2;
  run_of(now, "kepler", "rk4", 64).status = "not_finite";
  run_of(now, "kepler", "rk4", 128).state_hash = "f";
  run_of(now, "kepler", "rk4", 256).errors->scaled = std::numeric_limits<double>::quiet_NaN();
  run_of(now, "kepler", "rk4", 512).work.evaluations *= 2;
  const auto result = compare({{"a", before}, {"b", now}});
  const auto verdict = [&](const char* steps) {
    return cell_of(result.runs, std::string("convergence/kepler/rk4/double/steps=") + steps, "verdict");
  };
  EXPECT_EQ(verdict("16"), "regressed");
  EXPECT_EQ(verdict("32"), "improved");
  EXPECT_EQ(verdict("64"), "regressed");
  EXPECT_EQ(verdict("128"), "changed");
  EXPECT_EQ(verdict("256"), "regressed");
  EXPECT_EQ(verdict("512"), "regressed");
  EXPECT_EQ(verdict("1024"), "same");
  EXPECT_EQ(cell_of(result.runs, "convergence/kepler/rk4/double/steps=16", "error"), "2.00x");
  EXPECT_EQ(result.regressed, 4);
  EXPECT_EQ(result.improved, 1);
  EXPECT_EQ(result.changed, 1);
  EXPECT_EQ(compare({{"a", before}, {"b", now}}, CompareFilter::regressed).runs.rows.size(), 4u);
  EXPECT_EQ(compare({{"a", before}, {"b", now}}, CompareFilter::improved).runs.rows.size(), 1u);
  EXPECT_EQ(compare({{"a", before}, {"b", now}}, CompareFilter::changed).runs.rows.size(), 6u);
  EXPECT_NO_THROW(to_text(result.runs) + to_markdown(result.orders) + to_csv(result.one_side));
}

TEST(compare, times_differ_only_beyond_their_scatter) {
  std::vector<Row> before{good_run("kepler", "rk4", 4, 16)}, now = before;
  const auto time_cell = [&](double a, double a_mad, double b, double b_mad) {
    before[0].timing = timing(a, a_mad), now[0].timing = timing(b, b_mad);
    return cell_of(compare({{"a", before}, {"b", now}}).runs, before[0].id, "time");
  };
  EXPECT_EQ(time_cell(1e-6, 1e-8, 1.2e-6, 1e-8), "~") << "a small ratio";
  EXPECT_EQ(time_cell(1e-6, 2e-7, 2e-6, 2e-7), "~") << "within the scatter";
  EXPECT_EQ(time_cell(1e-6, 1e-8, 2e-6, 1e-8), "2.00x");
  EXPECT_EQ(time_cell(1e-6, 1e-8, 5e-7, 1e-8), "0.500x");
  EXPECT_EQ(time_cell(0, 0, 5e-7, 1e-8), "–");
}

TEST(compare, orders_and_what_only_one_side_has) {
  const auto before = good_rows();
  auto now = before;
  for (Row& row : now)
    if (row.method == "heun") row.errors->scaled *= std::sqrt(0.7 / row.dt.value());
  now.erase(now.begin());
  now.push_back(good_run("pendulum", "rk4", 4, 16));
  const auto result = compare({{"a", before}, {"b", now}, {"c", before}});
  EXPECT_EQ(cell_of(result.orders, "kepler/heun", "change"), "-0.50");
  EXPECT_EQ(cell_of(result.orders, "kepler/heun", "verdict"), "regressed");
  ASSERT_EQ(result.one_side.rows.size(), 2u);
  EXPECT_EQ(result.one_side.rows[0][1].text, "a");
  EXPECT_EQ(result.one_side.rows[1][1].text, "b");
  EXPECT_THROW(compare({{"a", before}}), std::invalid_argument);
}

TEST(compare, limits_that_moved_vanished_or_are_on_one_side) {
  const std::vector<StabilityRow> before{good_limit("rk4", "limit", 2.8), good_limit("heun", "unstable", 0),
                                         good_limit("gauss4", "unlimited", 0),
                                         good_limit("rk38", "limit", 2.8),
                                         good_limit("kutta3", "limit", 1.7)};
  auto now = before;
  now[0].measured = 2.7, now[1].verdict = "limit", now[1].measured = 0.1;
  now[2].verdict = "unstable", now[3].measured = 2.8 * (1 + 1e-8);
  now.back().method = "ralston3";
  const auto result = compare({{"a", good_rows(), before}, {"b", good_rows(), now}}, CompareFilter::changed);
  const auto verdict = [&](const char* method) {
    return cell_of(result.limits, std::string("stability/oscillator/") + method + "/double", "verdict");
  };
  EXPECT_EQ(verdict("rk4"), "regressed");
  EXPECT_EQ(verdict("heun"), "improved");
  EXPECT_EQ(verdict("gauss4"), "regressed");
  EXPECT_EQ(verdict("rk38"), "none") << "within what two measurements differ by";
  EXPECT_EQ(result.regressed, 2);
  EXPECT_EQ(result.improved, 1);
  EXPECT_EQ(result.same, static_cast<int>(good_rows().size()) + 1);
  ASSERT_EQ(result.one_side.rows.size(), 2u);
  EXPECT_EQ(result.one_side.rows[0][0].text, "stability/oscillator/kutta3/double");
  EXPECT_EQ(result.one_side.rows[1][1].text, "b");
  EXPECT_EQ(compare({{"a", good_rows(), before}, {"b", good_rows()}}).one_side.rows.size(), before.size());
}

}  // namespace
}  // namespace odemark::check_texts_test
