// The report of one results file: a page, from plain data alone.
#pragma once

#include <string>
#include <vector>

#include "bench/data/pictures.hpp"
#include "bench/data/row.hpp"
#include "bench/data/stability.hpp"
#include "reports/convergence.hpp"
#include "reports/html.hpp"
#include "reports/work_curves.hpp"

namespace odemark {

struct ReportInput {
  RunHeader header;
  std::vector<Row> rows;
  std::vector<StabilityRow> stability;
  Pictures pictures;
  std::string title;         // empty: "odemark report"
  std::vector<Link> beside;  // other files of the report: "chapter.html", "csv/rows.csv"
  bool cut = false;          // the results file ends in the middle of a line: an interrupted run
};

/// Sections: overview, cheapest, one per problem, orders, stability, precision, conservation, failures, how
/// it was measured. The same input gives the same page. With many problems each has its charts on a page of
/// its own only.
Page report_page(const ReportInput& input);

struct NamedPage {
  std::string name;  // "problems/oscillator.html"
  Page page;
};

/// One page per problem: its section, and every method that was run on it.
std::vector<NamedPage> problem_pages(const ReportInput& input);

inline constexpr std::size_t problems_on_one_page = 12;

/// What all sections are made from.
struct ReportData {
  const ReportInput& input;
  std::vector<Row> rows;  // of the main pictures
  std::vector<ProblemCurves> problems;
  std::vector<ObservedOrder> orders, precision;
  Palette palette;
};

ReportData report_data(const ReportInput& input);

// Parts of the page.
Verdict report_verdict(const ReportData& data);
Section overview_section(const ReportData& data);
Section cheapest_section(const ReportData& data);
/// `linked`: with a link to the page of the problem.
Section problem_section(const ReportData& data, const ProblemCurves& problem, bool with_charts, bool linked);
Section orders_section(const ReportData& data);
Section tolerance_section(const ReportData& data);
Section precision_section(const ReportData& data);
Section conservation_section(const ReportData& data);
Section failures_section(const ReportData& data);
Section every_method_section(const ReportData& data, const ProblemCurves& problem);
Section how_section(const ReportData& data);

/// Where the page of a problem is, seen from the report.
std::string problem_page_name(const std::string& problem);

/// Null where the registry of the report does not have it.
const ProblemCard* find_card(const Pictures& pictures, const std::string& problem);
const Scene* find_scene(const Pictures& pictures, const std::string& problem);

}  // namespace odemark
