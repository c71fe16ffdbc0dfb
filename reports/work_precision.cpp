// Error against evaluations and against time.
#include "reports/work_precision.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "reports/cheapest.hpp"
#include "reports/convergence.hpp"
#include "reports/format.hpp"
#include "reports/numbers.hpp"

namespace odemark {
namespace {

constexpr double overview_error = 1e-6;

Series cost_series(const WorkCurve& curve, const Palette& palette, Cost cost) {
  Series series{curve.label, curve.label, curve.family, {}, palette.style_of(curve.method)};
  if (curve.adaptive) series.style.line = Line::dashed;
  for (const CurvePoint& p : curve.points) {
    if (cost == Cost::time && !std::isfinite(p.time)) continue;  // failed runs are not timed
    series.points.push_back({rounded(p.cost(cost)), rounded(p.error), p.failed,
                             fmt::format("{} {}{}", curve.adaptive ? "tol" : "dt", compact(p.control, 3),
                                         p.failed ? ", " + p.status : "")});
  }
  return series;
}

Cell offer_cell(const WorkCurve& curve, double error, Cost cost) {
  const auto offer = offer_of(curve, error, cost);
  if (!offer) return {std::string(no_value), Status::muted};
  return {(offer->at_most ? "≤ " : "") + cost_text(*offer, cost), Status::plain, rounded(offer->cost, 4)};
}

double sort_cost(const ProblemCurves& problem, const WorkCurve& curve) {
  const auto offer = offer_of(curve, overview_error, problem.timed ? Cost::time : Cost::evaluations);
  return offer ? offer->cost : infinity;
}

/// Digits and relative time of the best curve that a method has on a problem.
Cell overview_cell(const ProblemCurves& problem, const std::string& method, double fastest, Cost cost) {
  double digits = -infinity, ratio = infinity;
  bool seen = false;
  for (const WorkCurve& curve : problem.curves) {
    if (curve.method != method) continue;
    seen = true;
    const double least = smallest_error(curve);
    if (std::isfinite(least)) digits = std::max(digits, -std::log10(std::max(least, 1e-20)));
    if (const auto offer = offer_of(curve, overview_error, cost))
      ratio = std::min(ratio, offer->cost / fastest);
  }
  if (!seen) return {"", Status::muted};
  if (!std::isfinite(digits)) return {"failed", Status::fail, -1};
  const std::string speed = std::isfinite(ratio)
                                ? fmt::format("{} ×", ratio < 9.95  ? fmt::format("{:.1f}", ratio)
                                                      : ratio < 1e4 ? fmt::format("{:.0f}", ratio)
                                                                    : compact(ratio, 1))
                                : std::string(no_value);
  const Status status = ratio <= 1.05 ? Status::ok : std::isfinite(ratio) ? Status::plain : Status::muted;
  return {fmt::format("{:.1f} | {}", digits, speed), status, rounded(digits, 4)};
}

}  // namespace

Chart error_by_cost(const ProblemCurves& problem, const Palette& palette, Cost cost) {
  const bool time = cost == Cost::time;
  Chart chart{.id = problem.problem + (time ? "-time" : "-work"),
              .title = problem.problem + (time ? ": error against time" : ": error against evaluations"),
              .caption = ""};
  chart.x = {.label = time ? "ns per simulated second" : "evaluations", .scale = Scale::log10};
  chart.y = {.label = "scaled error", .scale = Scale::log10};
  for (const std::size_t i : best_of_family(problem, false))
    if (Series series = cost_series(problem.curves[i], palette, cost); !series.points.empty())
      chart.series.push_back(std::move(series));
  if (chart.series.empty()) return chart;
  if (problem.floor > 0)
    chart.bands.push_back(
        {.direction = Direction::horizontal, .high = problem.floor, .label = "round-off floor"});
  if (!time) chart.slopes = SlopeFan{{-1, -2, -4}};
  chart.caption = time ? "Down and left is better. Dashed: the method chooses its own steps. Runs that did "
                         "not reach the end were not timed."
                       : "Down and left is better. Dashed: the method chooses its own steps. Jacobians and "
                         "matrix solves of implicit methods are not in this count, but in the time below.";
  return chart;
}

Table method_table(const ProblemCurves& problem, const std::vector<ObservedOrder>& orders) {
  Table table{problem.problem + "-methods", problem.problem + ": every method", "", {}, {}};
  table.columns = {{"method"},
                   {"order", Align::right},
                   {"measured", Align::right},
                   {"smallest error", Align::right},
                   {"evaluations to 10⁻³", Align::right},
                   {"to 10⁻⁶", Align::right},
                   {"to 10⁻⁹", Align::right},
                   {"time to 10⁻³", Align::right},
                   {"time to 10⁻⁶", Align::right},
                   {"time to 10⁻⁹", Align::right},
                   {"failed runs", Align::right}};
  table.note = "Times are per simulated second. Cheapest to 10⁻⁶ first.";
  std::vector<const WorkCurve*> sorted;
  for (const WorkCurve& curve : problem.curves) sorted.push_back(&curve);
  std::map<const WorkCurve*, std::pair<double, double>> key;
  for (const WorkCurve* curve : sorted) {
    const double least = smallest_error(*curve);
    key[curve] = {sort_cost(problem, *curve), std::isfinite(least) ? least : infinity};
  }
  std::stable_sort(sorted.begin(), sorted.end(),
                   [&](const WorkCurve* a, const WorkCurve* b) { return key[a] < key[b]; });
  for (const WorkCurve* curve : sorted) {
    std::vector<Cell> row{{curve->label}, {std::to_string(curve->order), Status::plain, curve->order}};
    const auto order = std::find_if(orders.begin(), orders.end(), [&](const ObservedOrder& o) {
      return o.id.problem == problem.problem && o.id.method == curve->method;
    });
    if (curve->adaptive || order == orders.end() || !order->slope)
      row.push_back({std::string(no_value), Status::muted});
    else
      row.push_back(
          {fmt::format("{:.2f}", *order->slope), status_of(order->verdict), rounded(*order->slope, 4)});
    const double least = smallest_error(*curve);
    row.push_back(number_cell(rounded(least, 3), scientific(least, 2)));
    for (const Cost cost : {Cost::evaluations, Cost::time})
      for (const double error : {1e-3, 1e-6, 1e-9}) row.push_back(offer_cell(*curve, error, cost));
    const auto failed = curve->failures();
    row.push_back({failed ? fmt::format("{} of {}", failed, curve->points.size()) : "",
                   failed ? Status::warn : Status::plain, static_cast<double>(failed)});
    table.rows.push_back(std::move(row));
  }
  return table;
}

std::string answer(const ProblemCurves& problem) {
  for (const double error : {1e-6, 1e-3, 1e-2}) {
    const auto work = cheapest(problem, error, Cost::evaluations);
    if (work.empty()) continue;
    const auto side = [&](const Offer& offer, Cost cost) {
      return fmt::format("({}{}, {})", offer.at_most ? "at most " : "", cost_text(offer, cost),
                         control_text(offer));
    };
    std::string text = fmt::format("To {}, {} needs the fewest evaluations {}", target_text(error),
                                   work[0].label, side(work[0], Cost::evaluations));
    if (const auto fast = cheapest(problem, error, Cost::time); !fast.empty())
      text +=
          fmt::format(" and {} the least time per simulated second {}",
                      fast[0].method == work[0].method ? "also" : fast[0].label, side(fast[0], Cost::time));
    const auto rk4 = std::find_if(work.begin(), work.end(), [](const Offer& o) { return o.label == "rk4"; });
    if (rk4 != work.end() && rk4 != work.begin())
      text += fmt::format("; rk4 takes {} times the evaluations", compact(rk4->cost / work[0].cost, 2));
    return text + ".";
  }
  return "No method that was run gets below an error of 10⁻² here.";
}

Table overview(const std::vector<ProblemCurves>& problems) {
  const bool timed = std::any_of(problems.begin(), problems.end(), [](const auto& p) { return p.timed; });
  const Cost cost = timed ? Cost::time : Cost::evaluations;
  Table table{
      "overview-table", "Digits reached | cost to 10⁻⁶ as a multiple of the cheapest", "", {{"method"}}, {}};
  std::vector<std::string> methods;
  std::vector<double> fastest;
  for (const ProblemCurves& problem : problems) {
    table.columns.push_back({problem.problem, Align::right});
    const auto offers = cheapest(problem, overview_error, cost);
    fastest.push_back(offers.empty() ? 1 : offers[0].cost);
    for (const std::size_t i : best_of_family(problem, false))
      if (const auto& id = problem.curves[i].method;
          std::find(methods.begin(), methods.end(), id) == methods.end())
        methods.push_back(id);
  }
  for (const auto& method : methods) {
    std::vector<Cell> row{{method}};
    for (std::size_t p = 0; p < problems.size(); ++p)
      row.push_back(overview_cell(problems[p], method, fastest[p], cost));
    table.rows.push_back(std::move(row));
  }
  table.note = fmt::format(
      "Digits: -log10 of the smallest scaled error at the end. Cost: {} to 10⁻⁶. ✓: within 5 % of the "
      "cheapest; –: 10⁻⁶ was not reached. Methods: the best of each family on some problem, and four that "
      "everybody knows; all are in the tables of the problems.",
      timed ? "time per simulated second" : "evaluations");
  return table;
}

}  // namespace odemark
