// The sections of the report that answer: what to take, what each problem shows, what failed.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "reports/cheapest.hpp"
#include "reports/conservation.hpp"
#include "reports/failures.hpp"
#include "reports/format.hpp"
#include "reports/precision.hpp"
#include "reports/report_page.hpp"
#include "reports/settling.hpp"
#include "reports/shown_error.hpp"
#include "reports/speed_ratio.hpp"
#include "reports/step_sizes.hpp"
#include "reports/tolerance.hpp"
#include "reports/trajectory_page.hpp"
#include "reports/work_precision.hpp"

namespace odemark {
namespace {

double dt_of_interest(const ReportData& data, const std::string& problem) {
  if (const ProblemCard* card = find_card(data.input.pictures, problem)) return card->suggested_dt;
  std::vector<double> dts;
  for (const Row& row : data.rows)
    if (row.problem == problem && row.dt) dts.push_back(*row.dt);
  if (dts.empty()) return 1;
  std::nth_element(dts.begin(), dts.begin() + static_cast<std::ptrdiff_t>(dts.size() / 2), dts.end());
  return dts[dts.size() / 2];
}

std::vector<std::pair<std::string, int>> winners(const ReportData& data, double error, Cost cost) {
  std::map<std::string, int> wins;
  for (const ProblemCurves& problem : data.problems)
    if (const auto offers = cheapest(problem, error, cost); !offers.empty()) ++wins[offers[0].method];
  std::vector<std::pair<std::string, int>> sorted(wins.begin(), wins.end());
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const auto& a, const auto& b) { return a.second > b.second; });
  return sorted;
}

std::string winners_sentence(const ReportData& data, double error, Cost cost, const char* what) {
  const auto sorted = winners(data, error, cost);
  if (sorted.empty()) return "";
  std::string text = fmt::format("{} to an error of {}: ", what, target_text(error));
  for (std::size_t i = 0; i < sorted.size(); ++i)
    text += fmt::format("{}{} ({}{})", i == 0 ? "" : ", ", sorted[i].first, sorted[i].second,
                        i > 0                   ? ""
                        : sorted[i].second == 1 ? " problem"
                                                : " problems");
  return text + ".";
}

void add_answer(Section& section, const std::string& text) {
  if (!text.empty()) section.blocks.push_back(Paragraph{text});
}

Table problem_facts(const ProblemCard* known, const std::string& problem, bool linked) {
  Table table{problem + "-facts", "", "", {{"the problem"}, {""}}, {}};
  const auto add = [&](const char* what, const std::string& value) {
    if (!value.empty()) table.rows.push_back({{what}, {value}});
  };
  if (linked)
    table.rows.push_back(
        {{"every method"},
         {"all curves and costs on one page", Status::plain, {}, problem_page_name(problem)}});
  if (!known) return table;
  const ProblemCard& card = *known;
  add("equations", card.equations);
  std::string parameters;
  for (const auto& p : card.parameters) parameters += (parameters.empty() ? "" : ",  ") + p;
  add("parameters", parameters);
  add("suggested dt", compact(card.suggested_dt, 3) + " s");
  add("truth", card.truth);
  add("source", card.source);
  return table;
}

std::string tier_note(const ProblemCurves& problem) {
  bool inlined = false, called = false;
  for (const WorkCurve& curve : problem.curves)
    for (const CurvePoint& p : curve.points) inlined |= p.tier == "static", called |= p.tier == "erased";
  if (inlined && called)
    return "Times of our own methods are with the right-hand side inlined into the step where that tier was "
           "compiled, the others call it through a pointer: see how it was measured.";
  return "";
}

/// "cvode_adams, cvode_bdf: what is the matter": is one of them here? What names nobody concerns all.
bool concerns(const std::string& footnote, const std::set<std::string>& methods) {
  const std::size_t colon = footnote.find(':');
  if (colon == footnote.npos) return true;
  for (std::size_t at = 0; at < colon;) {
    const std::size_t end = std::min(footnote.find(',', at), colon);
    if (methods.contains(footnote.substr(at, end - at))) return true;
    at = footnote.find_first_not_of(' ', end + 1);
  }
  return false;
}

}  // namespace

Section overview_section(const ReportData& data) {
  Section section{"overview", "Overview", {}};
  if (data.problems.empty()) return section;
  add_answer(section, winners_sentence(data, 1e-6, Cost::evaluations, "Fewest evaluations"));
  add_answer(section, winners_sentence(data, 1e-6, Cost::time, "Least time"));
  std::set<std::string> present;
  for (const Row& row : data.input.rows) present.insert(row.method);
  for (const auto& footnote : data.input.header.footnotes)
    if (concerns(footnote, present)) section.blocks.push_back(Paragraph{footnote, Status::warn});
  section.blocks.push_back(overview(data.problems));
  return section;
}

Section cheapest_section(const ReportData& data) {
  Section section{"cheapest", "Cheapest", {}};
  const auto rough = winners(data, 1e-2, Cost::evaluations), fine = winners(data, 1e-9, Cost::evaluations);
  if (!rough.empty() && !fine.empty())
    add_answer(section, fmt::format("For an error of {} {} needs the fewest evaluations most often ({} of {} "
                                    "problems), for {} it is {} ({}).",
                                    target_text(1e-2), rough[0].first, rough[0].second, data.problems.size(),
                                    target_text(1e-9), fine[0].first, fine[0].second));
  section.blocks.push_back(cheapest_table(data.problems, Cost::evaluations));
  const bool timed =
      std::any_of(data.problems.begin(), data.problems.end(), [](const ProblemCurves& p) { return p.timed; });
  if (timed) section.blocks.push_back(cheapest_table(data.problems, Cost::time));
  if (compares_codes(data.problems)) section.blocks.push_back(speed_ratio_table(speed_ratios(data.problems)));
  return section;
}

Section problem_section(const ReportData& data, const ProblemCurves& problem, bool with_charts, bool linked) {
  const ProblemCard* card = find_card(data.input.pictures, problem.problem);
  Section section{"problem-" + problem.problem, problem.problem, {}};
  add_answer(section, answer(problem));
  if (card)
    add_answer(section, fmt::format("{}{}{}. Simulated for {} s.", card->title,
                                    card->about.empty() ? "" : ": ", card->about, compact(card->t_end, 4)));
  if (std::any_of(data.rows.begin(), data.rows.end(),
                  [&](const Row& row) { return row.problem == problem.problem && dies_before_the_end(row); }))
    add_answer(
        section,
        "Next to nothing of the motion is left at the end, and any error is small there: errors are the "
        "largest at the common times instead. An end while it still moves (--set t_end=...) says more.");
  section.blocks.push_back(problem_facts(card, problem.problem, linked));
  if (!with_charts) return section;
  const auto add_chart = [&](Chart chart) {
    if (!chart.series.empty()) section.blocks.push_back(std::move(chart));
  };
  if (const Scene* scene = find_scene(data.input.pictures, problem.problem))
    add_chart(trajectory_chart(*scene));
  add_chart(error_by_dt(problem, data.palette, Shown::best_of_family, data.orders, card));
  add_chart(error_by_cost(problem, data.palette, Cost::evaluations));
  if (problem.timed) {
    add_chart(error_by_cost(problem, data.palette, Cost::time));
    add_answer(section, tier_note(problem));
  }
  return section;
}

Section orders_section(const ReportData& data) {
  Section section{"orders", "Orders", {}};
  const OrderCounts c = count_orders(data.orders);
  add_answer(section,
             fmt::format("Of {} order claims {} hold, {} fail, {} exceed, and {} could not be judged.",
                         c.total(), c.holds, c.fails, c.exceeds, c.inconclusive));
  if (c.fails) section.blocks.push_back(failed_orders(data.orders, data.input.pictures.methods));
  section.blocks.push_back(order_matrix(data.orders));
  return section;
}

Section tolerance_section(const ReportData& data) {
  Section section{"tolerance", "Tolerance", {}};
  // of suites that look at single steps: a line per code and problem is much for a page about something else
  if (std::none_of(data.rows.begin(), data.rows.end(), [](const Row& r) { return r.local.has_value(); }))
    return section;
  const auto codes = calibrations(data.rows);
  long judged = 0, deceived = 0, honest = 0, sloped = 0;
  for (const Calibration& code : codes) {
    judged += code.judged, deceived += code.deceived;
    if (!code.slope || !code.expected_slope) continue;
    ++sloped;
    honest += std::abs(*code.slope - *code.expected_slope) <= 0.2;
  }
  if (sloped > 0)
    add_answer(section,
               fmt::format("In {} of {} cases the error at the end follows the tolerance as theory says, "
                           "to within 0.2 of the slope.",
                           honest, sloped));
  if (judged > 0)
    add_answer(section,
               fmt::format("Of {} accepted steps judged against the exact solution through their start, "
                           "{} had a true error above the tolerance.",
                           judged, deceived));
  if (const auto& settling = data.input.pictures.settling; !settling.empty())
    add_answer(section, settling_answer(settling));
  for (const ProblemCurves& problem : data.problems)
    if (Chart chart = step_size_chart(data.rows, problem.problem, data.palette); !chart.series.empty())
      section.blocks.push_back(std::move(chart));
  section.blocks.push_back(calibration_table(codes));
  if (const auto& settling = data.input.pictures.settling; !settling.empty())
    section.blocks.push_back(settling_table(settling));
  return section;
}

Section precision_section(const ReportData& data) {
  Section section{"precision", "Precision", {}};
  for (const auto& problem : precision_problems(data.precision))
    add_answer(section, precision_answer(data.precision, problem));
  for (const auto& problem : precision_problems(data.precision)) {
    if (Chart chart = precision_chart(data.precision, problem); !chart.series.empty())
      section.blocks.push_back(std::move(chart));
    section.blocks.push_back(roundoff_table(data.precision, problem));
  }
  return section;
}

Section conservation_section(const ReportData& data) {
  Section section{"conservation", "Conservation", {}};
  const auto problems = conserving_problems(data.rows);
  for (const auto& problem : problems)
    add_answer(section, drift_answer(data.rows, problem, dt_of_interest(data, problem)));
  for (const auto& problem : problems) {
    const double dt = dt_of_interest(data, problem);
    if (Table table = drift_table(data.rows, problem, dt); !table.rows.empty())
      section.blocks.push_back(std::move(table));
  }
  for (const ProblemCurves& problem : data.problems)
    if (Table table = oscillation_table(data.rows, problem.problem, dt_of_interest(data, problem.problem));
        !table.rows.empty())
      section.blocks.push_back(std::move(table));
  return section;
}

Section failures_section(const ReportData& data) {
  Section section{"failures-section", "Failures", {}};
  const auto counts = failures_by_status(data.input.rows);
  int total = 0;
  std::string text;
  for (const auto& [status, count] : counts) {
    total += count;
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, status);
  }
  add_answer(section, total ? fmt::format("{} runs did not reach the end: {}.", total, text)
                            : std::string("Every run reached its end."));
  for (Table table : {failure_table(data.input.rows), without_truth_table(data.input.rows),
                      not_applicable_table(data.input.rows)})
    if (!table.rows.empty()) section.blocks.push_back(std::move(table));
  return section;
}

Section every_method_section(const ReportData& data, const ProblemCurves& problem) {
  Section section{"every-method", "Every method", {}};
  Chart chart = error_by_dt(problem, data.palette, Shown::all, data.orders,
                            find_card(data.input.pictures, problem.problem));
  if (!chart.series.empty()) section.blocks.push_back(std::move(chart));
  section.blocks.push_back(method_table(problem, data.orders));
  return section;
}

}  // namespace odemark
