// Where round-off takes over.
#include "reports/precision.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

#include "reports/format.hpp"
#include "reports/numbers.hpp"
#include "reports/palette.hpp"
#include "reports/work_curves.hpp"

namespace odemark {
namespace {

constexpr std::array<std::string_view, 4> shown_methods{"explicit_euler", "heun", "rk4", "taylor8"};

struct NumberKind {
  std::string_view scalar, name;
  bool compensated;
};
constexpr std::array<NumberKind, 6> kinds{{{"float", "float", false},
                                           {"float", "float, compensated", true},
                                           {"double", "double", false},
                                           {"double", "double, compensated", true},
                                           {"long_double", "long double", false},
                                           {"long_double", "long double, compensated", true}}};

const ObservedOrder* find(const std::vector<ObservedOrder>& orders, const std::string& problem,
                          std::string_view method, const NumberKind& kind) {
  for (const ObservedOrder& o : orders)
    if (o.id.problem == problem && o.id.method == method && o.id.scalar == kind.scalar &&
        o.id.compensated == kind.compensated)
      return &o;
  return nullptr;
}

std::vector<std::string> methods_of(const std::vector<ObservedOrder>& orders, const std::string& problem) {
  std::vector<std::string> methods;
  for (const ObservedOrder& o : orders)
    if (o.id.problem == problem && std::find(methods.begin(), methods.end(), o.id.method) == methods.end())
      methods.push_back(o.id.method);
  return methods;
}

Cell onset_cell(const ObservedOrder* order) {
  if (!order) return {"", Status::muted};
  const RoundoffOnset onset = roundoff_onset(*order);
  const double least = onset.error_minimum.value_or(absent);
  if (onset.dt)
    return {fmt::format("{} | {}", compact(*onset.dt, 2), scientific(least, 1)), Status::plain, *onset.dt};
  if (order->rungs.empty()) return {"no run gave an error", Status::muted};
  return {fmt::format("not reached | {}", scientific(least, 1)), Status::muted, 0};
}

}  // namespace

std::vector<ObservedOrder> precision_orders(const std::vector<Row>& rows) {
  std::map<std::string, std::set<std::pair<std::string, bool>>> types;
  for (const Row& row : rows)
    if (row.steps && row.status != "not_applicable") types[row.problem].emplace(row.scalar, row.compensated);
  std::vector<Row> chosen;  // the plan "precision" first: of equal steps the first row is taken
  for (const bool precision : {true, false})
    for (const Row& row : rows)
      if (row.steps && (row.plan == "precision") == precision && types[row.problem].size() > 1)
        chosen.push_back(row);
  return observed_orders(chosen);
}

std::vector<std::string> precision_problems(const std::vector<ObservedOrder>& orders) {
  std::vector<std::string> problems;
  for (const ObservedOrder& o : orders)
    if (std::find(problems.begin(), problems.end(), o.id.problem) == problems.end())
      problems.push_back(o.id.problem);
  return problems;
}

Table roundoff_table(const std::vector<ObservedOrder>& orders, const std::string& problem) {
  Table table{problem + "-roundoff",
              problem + ": dt [s] where round-off takes over | smallest error",
              "",
              {{"method"}},
              {}};
  std::vector<const NumberKind*> columns;
  const auto methods = methods_of(orders, problem);
  for (const NumberKind& kind : kinds)
    if (std::any_of(methods.begin(), methods.end(),
                    [&](const auto& m) { return find(orders, problem, m, kind) != nullptr; })) {
      columns.push_back(&kind);
      table.columns.push_back({std::string(kind.name), Align::right});
    }
  double finest = infinity;
  for (const ObservedOrder& o : orders)
    if (o.id.problem == problem && !o.rungs.empty()) finest = std::min(finest, o.rungs.back().dt);
  for (const auto& method : methods) {
    std::vector<Cell> row{{method}};
    for (const NumberKind* kind : columns) row.push_back(onset_cell(find(orders, problem, method, *kind)));
    table.rows.push_back(std::move(row));
  }
  table.note = fmt::format(
      "The dt at which the error leaves its order line by a factor of two; where no order line was found, "
      "the dt of the smallest error. Not reached: the error still follows the line at the smallest dt that "
      "was run, {} s.",
      compact(finest, 2));
  return table;
}

Chart precision_chart(const std::vector<ObservedOrder>& orders, const std::string& problem) {
  Chart chart{.id = problem + "-precision",
              .title = problem + ": error against dt in every number type",
              .caption = ""};
  chart.x = {.label = "dt [s]", .scale = Scale::log10};
  chart.y = {.label = "scaled error", .scale = Scale::log10};
  std::vector<PaletteMember> members;  // colour by method, marker by number type
  for (const auto& method : shown_methods)
    for (const NumberKind& kind : kinds)
      members.push_back({fmt::format("{}, {}", method, kind.name), std::string(method)});
  const Palette palette(members);
  for (const auto& method : shown_methods) {
    for (const NumberKind& kind : kinds) {
      const ObservedOrder* order = find(orders, problem, method, kind);
      if (!order || order->rungs.empty() || (kind.compensated && kind.scalar != "float")) continue;
      const std::string label = fmt::format("{}, {}", method, kind.name);
      Series series{label, std::string(kind.name), std::string(method), {}, palette.style_of(label)};
      series.style.filled = !kind.compensated;
      if (kind.compensated) series.style.line = Line::dotted;
      for (const Rung& rung : order->rungs) series.points.push_back({rounded(rung.dt), rounded(rung.error)});
      chart.series.push_back(std::move(series));
    }
  }
  chart.caption =
      "Where a curve leaves its straight line and rises again, more steps make it worse. Hollow and dotted: "
      "float with compensated sums.";
  return chart;
}

std::string precision_answer(const std::vector<ObservedOrder>& orders, const std::string& problem) {
  for (const std::string_view method : {"rk4", "heun", "explicit_euler"}) {
    const ObservedOrder* single = find(orders, problem, method, kinds[0]);
    if (!single) continue;
    const RoundoffOnset onset = roundoff_onset(*single);
    if (!onset.dt) continue;
    std::string text =
        fmt::format("{}: in float, {} gains nothing below dt = {} s, where its error is {}", problem, method,
                    compact(*onset.dt, 2), scientific(onset.error_minimum.value_or(absent), 1));
    if (const ObservedOrder* helped = find(orders, problem, method, kinds[1])) {
      const RoundoffOnset later = roundoff_onset(*helped);
      text += fmt::format("; compensated sums bring it to {}",
                          scientific(later.error_minimum.value_or(absent), 1));
    }
    if (const ObservedOrder* wide = find(orders, problem, method, kinds[2])) {
      const RoundoffOnset later = roundoff_onset(*wide);
      text += fmt::format(", double to {}{}", scientific(later.error_minimum.value_or(absent), 1),
                          later.dt ? "" : ", where smaller steps would still help");
    }
    return text + ".";
  }
  return "";
}

}  // namespace odemark
