// The report page, put together from its sections.
#include "reports/report_page.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "reports/failures.hpp"
#include "reports/markup.hpp"
#include "reports/precision.hpp"
#include "reports/stability_page.hpp"

namespace odemark {
namespace {

std::string subtitle(const RunHeader& h) {
  std::string text = fmt::format("suite {} · odemark {}", h.suite, h.version);
  if (!h.revision.empty()) text += fmt::format(" ({})", h.revision);
  for (const auto* part : {&h.date, &h.processor, &h.compiler})
    if (!part->empty()) text += " · " + *part;
  return text;
}

std::vector<Badge> badges(const ReportData& data) {
  std::vector<Badge> out;
  const OrderCounts orders = count_orders(data.orders);
  if (orders.holds) out.push_back({fmt::format("{} order claims hold", orders.holds), Status::ok});
  if (orders.fails) out.push_back({fmt::format("{} fail", orders.fails), Status::fail});
  if (orders.exceeds) out.push_back({fmt::format("{} exceed", orders.exceeds), Status::note});
  if (orders.inconclusive) out.push_back({fmt::format("{} inconclusive", orders.inconclusive)});
  if (const StabilityCounts s = count_stability(data.input.stability); s.agrees + s.differs > 0) {
    out.push_back({fmt::format("{} stability limits agree with theory", s.agrees), Status::ok});
    if (s.differs) out.push_back({fmt::format("{} differ", s.differs), Status::fail});
  }
  for (const auto& [status, count] : failures_by_status(data.input.rows))
    out.push_back({fmt::format("{} runs {}", count, status), Status::warn});
  return out;
}

}  // namespace

const ProblemCard* find_card(const Pictures& pictures, const std::string& problem) {
  const auto at = std::find_if(pictures.problems.begin(), pictures.problems.end(),
                               [&](const ProblemCard& card) { return card.id == problem; });
  return at == pictures.problems.end() ? nullptr : &*at;
}

const Scene* find_scene(const Pictures& pictures, const std::string& problem) {
  const auto at = std::find_if(pictures.scenes.begin(), pictures.scenes.end(),
                               [&](const Scene& scene) { return scene.problem == problem; });
  return at == pictures.scenes.end() ? nullptr : &*at;
}

Verdict report_verdict(const ReportData& data) {
  const auto& rows = data.input.rows;
  const auto runs =
      std::count_if(rows.begin(), rows.end(), [](const Row& r) { return r.status != "not_applicable"; });
  if (runs == 0 && data.input.stability.empty())
    return {Status::warn, "Nothing was measured: these results hold no run.", {}};
  const OrderCounts orders = count_orders(data.orders);
  const StabilityCounts stability = count_stability(data.input.stability);
  int failed = 0;
  for (const auto& [status, count] : failures_by_status(rows)) failed += count;
  const int disagreements = orders.fails + stability.differs;
  std::vector<std::string> parts;
  if (orders.fails) parts.push_back(fmt::format("{} of {} order claims", orders.fails, orders.total()));
  if (stability.differs)
    parts.push_back(
        fmt::format("{} of {} stability limits", stability.differs, stability.agrees + stability.differs));
  Verdict verdict;
  const int judged = orders.holds + orders.exceeds + stability.agrees;
  verdict.status = disagreements ? Status::warn : judged ? Status::ok : Status::plain;
  verdict.text = !disagreements && !judged ? std::string("No order and no stability limit was measured here")
                 : disagreements
                     ? fmt::format("{} {} not hold; whatever else could be measured is as claimed",
                                   fmt::join(parts, " and "), disagreements == 1 ? "does" : "do")
                     : std::string(
                           "Every order and stability limit that could be measured is as "
                           "claimed");
  const Table failing = failed_orders(data.orders, data.input.pictures.methods);
  const auto noted = std::count_if(failing.rows.begin(), failing.rows.end(),
                                   [](const auto& row) { return !row.back().text.empty(); });
  if (noted > 0) verdict.text += fmt::format(" ({} with a note of the method that says why)", noted);
  verdict.text += fmt::format(". {} of {} runs reached the end.", runs - failed, runs);
  if (orders.fails) verdict.links.push_back({"order claims that do not hold", "#failed-orders"});
  if (stability.differs) verdict.links.push_back({"limits that differ", "#stability-differs"});
  if (failed) verdict.links.push_back({"runs that did not reach the end", "#failures"});
  if (data.input.cut)
    verdict.links.push_back({"the results file ends in the middle of a line: a run was interrupted", "#how"});
  return verdict;
}

ReportData report_data(const ReportInput& input) {
  auto rows = main_rows(input.rows);
  auto problems = work_curves(rows);
  auto orders = observed_orders(rows);
  return {input,
          std::move(rows),
          std::move(problems),
          std::move(orders),
          precision_orders(input.rows),
          report_palette(input.pictures.methods, input.rows)};
}

std::string problem_page_name(const std::string& problem) { return "problems/" + safe_id(problem) + ".html"; }

Page report_page(const ReportInput& input) {
  const ReportData data = report_data(input);
  Page page;
  page.title = input.title.empty() ? "odemark report" : input.title;
  page.subtitle = subtitle(input.header);
  page.verdict = report_verdict(data);
  page.badges = badges(data);
  page.sections.push_back(overview_section(data));
  if (!data.problems.empty()) page.sections.push_back(cheapest_section(data));
  const bool with_charts = data.problems.size() <= problems_on_one_page;
  for (const ProblemCurves& problem : data.problems)
    page.sections.push_back(problem_section(data, problem, with_charts, true));
  if (!data.orders.empty()) page.sections.push_back(orders_section(data));
  page.sections.push_back(stability_section(input.stability, input.pictures, data.palette));
  page.sections.push_back(tolerance_section(data));
  if (!data.precision.empty()) page.sections.push_back(precision_section(data));
  page.sections.push_back(conservation_section(data));
  page.sections.push_back(failures_section(data));
  page.sections.push_back(how_section(data));
  std::erase_if(page.sections, [](const Section& section) { return section.blocks.empty(); });
  for (const Section& section : page.sections) page.nav.push_back({section.heading, "#" + section.id});
  for (const Link& link : input.beside)
    if (link.href == "chapter.html") page.nav.push_back({"Chapter", link.href});
  page.footer =
      fmt::format("odemark {} · every number is in the files beside this page", input.header.version);
  return page;
}

std::vector<NamedPage> problem_pages(const ReportInput& input) {
  const ReportData data = report_data(input);
  std::vector<NamedPage> pages;
  for (const ProblemCurves& problem : data.problems) {
    Page page;
    page.title = problem.problem;
    page.subtitle = subtitle(input.header);
    page.sections = {problem_section(data, problem, true, false), every_method_section(data, problem)};
    page.nav = {{"← Report", "../report.html"}};
    for (const Section& section : page.sections) page.nav.push_back({section.heading, "#" + section.id});
    pages.push_back({problem_page_name(problem.problem), std::move(page)});
  }
  return pages;
}

}  // namespace odemark
