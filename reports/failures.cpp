// Failed runs, gathered into lines that can be read.
#include "reports/failures.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

#include "reports/format.hpp"
#include "reports/numbers.hpp"
#include "reports/observed_order.hpp"

namespace odemark {
namespace {

struct Gathered {
  std::string name, status, reason;
  bool adaptive = false;
  int failed = 0, made = 0;
  double lowest = infinity, highest = -infinity, earliest = infinity, latest = -infinity;
};

double control_of(const Row& row) { return row.rtol ? *row.rtol : row.dt.value_or(absent); }

std::string range_text(double low, double high, int digits) {
  if (!std::isfinite(low)) return std::string(no_value);
  return low == high ? compact(low, digits)
                     : fmt::format("{} … {}", compact(low, digits), compact(high, digits));
}

void add(Gathered& g, const Row& row) {
  ++g.failed;
  if (g.reason.empty()) g.reason = row.reason;
  const double control = control_of(row);
  g.lowest = std::min(g.lowest, control), g.highest = std::max(g.highest, control);
  if (std::isfinite(row.t_reached)) {
    g.earliest = std::min(g.earliest, row.t_reached);
    g.latest = std::max(g.latest, row.t_reached);
  }
}

bool failed(const Row& row) { return row.status != "reached_end" && row.status != "not_applicable"; }

}  // namespace

std::map<std::string, int> failures_by_status(const std::vector<Row>& rows) {
  std::map<std::string, int> counts;
  for (const Row& row : rows)
    if (failed(row)) ++counts[row.status];
  return counts;
}

Table failure_table(const std::vector<Row>& rows) {
  Table table{"failures", "Runs that did not reach the end", "", {}, {}};
  table.columns = {{"case"},
                   {"status"},
                   {"runs", Align::right},
                   {"dt or tolerance", Align::right},
                   {"stopped at t", Align::right, "s"},
                   {"reason"}};
  std::vector<Gathered> lines;
  std::map<std::tuple<CurveId, bool, std::string>, std::size_t> at;
  std::map<std::pair<CurveId, bool>, int> made;
  for (const Row& row : rows) {
    if (row.status == "not_applicable") continue;
    const bool adaptive = row.rtol.has_value();
    ++made[{curve_of(row), adaptive}];
    if (!failed(row)) continue;
    const auto [found, is_new] = at.emplace(std::tuple{curve_of(row), adaptive, row.status}, lines.size());
    if (is_new) lines.push_back({case_name(curve_of(row)), row.status, "", adaptive});
    add(lines[found->second], row);
  }
  for (const auto& [key, index] : at) lines[index].made = made[{std::get<0>(key), std::get<1>(key)}];
  for (const Gathered& g : lines)
    table.rows.push_back(
        {{g.name},
         {g.status, Status::warn},
         {fmt::format("{} of {}", g.failed, g.made), Status::plain, g.failed},
         {fmt::format("{} {}", g.adaptive ? "tol" : "dt", range_text(g.lowest, g.highest, 2)), Status::plain,
          g.lowest},
         {range_text(g.earliest, g.latest, 3), Status::plain,
          std::isfinite(g.earliest) ? std::optional(g.earliest) : std::nullopt},
         {g.reason}});
  return table;
}

Table not_applicable_table(const std::vector<Row>& rows) {
  Table table{"not-applicable", "Pairs that cannot be run", "", {{"why"}, {"method"}, {"problems"}}, {}};
  std::map<std::string, std::map<std::string, std::set<std::string>>> pairs;  // reason, method, problems
  for (const Row& row : rows)
    if (row.status == "not_applicable") pairs[row.reason][row.method].insert(row.problem);
  for (const auto& [reason, methods] : pairs)
    for (const auto& [method, problems] : methods)
      table.rows.push_back({{reason}, {method}, {fmt::format("{}", fmt::join(problems, ", "))}});
  return table;
}

Table without_truth_table(const std::vector<Row>& rows) {
  Table table{"without-truth",
              "Problems without a certified truth",
              "",
              {{"problem"}, {"why"}, {"runs", Align::right}},
              {}};
  std::map<std::pair<std::string, std::string>, int> counts;
  for (const Row& row : rows)
    if (row.status == "reached_end" && !row.errors) ++counts[{row.problem, row.reason}];
  for (const auto& [key, runs] : counts)
    table.rows.push_back({{key.first}, {key.second}, {std::to_string(runs), Status::plain, runs}});
  return table;
}

}  // namespace odemark
