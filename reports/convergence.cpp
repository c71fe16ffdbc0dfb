// Error against step size, and the orders read off it.
#include "reports/convergence.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "reports/format.hpp"
#include "reports/numbers.hpp"

namespace odemark {
namespace {

Series dt_series(const WorkCurve& curve, const Palette& palette, Shown shown) {
  Series series{curve.label, curve.label, curve.family, {}, palette.style_of(curve.method)};
  if (shown == Shown::all) series.style.marker = Marker::none;
  for (const CurvePoint& p : curve.points) {
    Point point{rounded(p.control), rounded(p.error), p.failed, p.failed ? p.status : ""};
    series.points.push_back(std::move(point));
  }
  return series;
}

std::string slopes_sentence(const std::vector<ObservedOrder>& orders, const Chart& chart,
                            const std::string& problem) {
  std::string text;
  for (const Series& series : chart.series)
    for (const ObservedOrder& order : orders)
      if (order.id.problem == problem && order.id.method == series.id && order.slope)
        text += fmt::format("{}{} {:.2f}", text.empty() ? "" : ", ", series.label, *order.slope);
  return text.empty() ? "No slope could be measured." : "Measured slopes: " + text + ".";
}

void add_guides(Chart& chart, const ProblemCurves& problem, const ProblemCard* card) {
  if (problem.floor > 0)
    chart.bands.push_back(
        {.direction = Direction::horizontal, .high = problem.floor, .label = "round-off floor"});
  double low = infinity, high = 0;
  for (const Series& series : chart.series)
    for (const Point& p : series.points) low = std::min(low, p.x), high = std::max(high, p.x);
  if (!card || !card->in_seconds) return;
  for (const int rate : {60, 1000})
    if (1.0 / rate >= low && 1.0 / rate <= high)
      chart.lines.push_back({Direction::vertical, 1.0 / rate, fmt::format("1/{} s", rate)});
}

std::vector<std::string> in_order(const std::vector<ObservedOrder>& orders, std::string CurveId::*part) {
  std::vector<std::string> names;
  for (const ObservedOrder& order : orders)
    if (std::find(names.begin(), names.end(), order.id.*part) == names.end()) names.push_back(order.id.*part);
  return names;
}

Cell slope_cell(const ObservedOrder& order) {
  if (!order.slope) return {std::string(no_value), Status::muted};
  const std::string lowered = order.because.empty() ? ""
                              : order.claimed == 0  ? " (none)"
                                                    : fmt::format(" ({})", order.claimed);
  return {fmt::format("{:.2f}{}", *order.slope, lowered), status_of(order.verdict), rounded(*order.slope, 4)};
}

}  // namespace

Status status_of(OrderVerdict verdict) {
  switch (verdict) {
    case OrderVerdict::holds: return Status::ok;
    case OrderVerdict::fails: return Status::fail;
    case OrderVerdict::exceeds: return Status::note;
    case OrderVerdict::inconclusive: return Status::muted;
  }
  return Status::plain;
}

Chart error_by_dt(const ProblemCurves& problem, const Palette& palette, Shown shown,
                  const std::vector<ObservedOrder>& orders, const ProblemCard* card) {
  const bool all = shown == Shown::all;
  Chart chart{.id = problem.problem + (all ? "-dt-all" : "-dt"),
              .title = problem.problem + (all ? ": error against dt, every method" : ": error against dt"),
              .caption = ""};
  chart.x = {.label = "dt [s]", .scale = Scale::log10};
  chart.y = {.label = "scaled error", .scale = Scale::log10};
  const auto chosen = best_of_family(problem, true);
  for (std::size_t i = 0; i < problem.curves.size(); ++i)
    if (!problem.curves[i].adaptive && (all || chosen.contains(i)))
      chart.series.push_back(dt_series(problem.curves[i], palette, shown));
  if (chart.series.empty()) return chart;
  add_guides(chart, problem, card);
  if (!all) {
    chart.slopes = SlopeFan{{1, 2, 4}};
    chart.caption = slopes_sentence(orders, chart, problem.problem);
  }
  return chart;
}

OrderCounts count_orders(const std::vector<ObservedOrder>& orders) {
  OrderCounts counts;
  for (const ObservedOrder& order : orders) switch (order.verdict) {
      case OrderVerdict::holds: ++counts.holds; break;
      case OrderVerdict::fails: ++counts.fails; break;
      case OrderVerdict::exceeds: ++counts.exceeds; break;
      case OrderVerdict::inconclusive: ++counts.inconclusive; break;
    }
  return counts;
}

Table order_matrix(const std::vector<ObservedOrder>& orders) {
  Table table{"orders", "Measured order of convergence", "", {{"method"}, {"claimed", Align::right}}, {}};
  const auto problems = in_order(orders, &CurveId::problem);
  for (const auto& problem : problems) table.columns.push_back({problem, Align::right});
  std::map<std::pair<std::string, std::string>, const ObservedOrder*> at;
  for (const ObservedOrder& order : orders) at.emplace(std::pair{order.id.method, order.id.problem}, &order);
  for (const auto& method : in_order(orders, &CurveId::method)) {
    std::vector<Cell> row{{method}, {}};
    for (const auto& problem : problems) {
      const auto found = at.find({method, problem});
      if (found == at.end()) {
        row.push_back({"", Status::muted});
        continue;
      }
      const int stated = found->second->stated;
      row[1] = {std::to_string(stated), Status::plain, stated};
      row.push_back(slope_cell(*found->second));
    }
    table.rows.push_back(std::move(row));
  }
  table.note =
      "Slope of ln(error) against ln(dt), fitted only where neighbouring slopes agree and the error is "
      "between a "
      "hundred times the floor and 0.1. ✓ at least the claimed order - 0.3; ✗ below; blue: above by more "
      "than 0.3, usually because the ladder is still coarse; –: no such stretch. Empty: the method does not "
      "apply. In brackets: the order expected on this problem where theory leaves less than is claimed.";
  return table;
}

Table failed_orders(const std::vector<ObservedOrder>& orders, const std::vector<MethodCard>& methods) {
  Table table{"failed-orders", "Order claims that do not hold", "", {}, {}};
  table.columns = {{"case"},
                   {"claimed", Align::right},
                   {"measured", Align::right},
                   {"dt of the fit", Align::left, "s"},
                   {"what was seen"},
                   {"what the method says"}};
  for (const ObservedOrder& order : orders) {
    if (order.verdict != OrderVerdict::fails) continue;
    const auto card = std::find_if(methods.begin(), methods.end(),
                                   [&](const MethodCard& m) { return m.id == order.id.method; });
    table.rows.push_back({{case_name(order.id)},
                          {std::to_string(order.claimed)},
                          slope_cell(order),
                          {fmt::format("{} … {}", compact(order.dt_max.value_or(absent), 2),
                                       compact(order.dt_min.value_or(absent), 2))},
                          {order.reason},
                          {card == methods.end() ? "" : card->note}});
  }
  return table;
}

}  // namespace odemark
