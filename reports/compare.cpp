// Matching by id; ratios; one word per run for the whole.
#include "reports/compare.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

#include "reports/format.hpp"
#include "reports/observed_order.hpp"
#include "reports/shown_error.hpp"
#include "reports/verdict.hpp"

namespace odemark {
namespace {

enum class Fate { same, changed, improved, regressed };

struct FateWord {
  std::string_view word;
  Status status;
};
FateWord in_words(Fate fate) {
  switch (fate) {
    case Fate::same: return {"same", Status::muted};
    case Fate::changed: return {"changed", Status::note};
    case Fate::improved: return {"improved", Status::ok};
    case Fate::regressed: return {"regressed", Status::fail};
  }
  return {"", Status::plain};
}

bool is_shown(Fate fate, CompareFilter filter) {
  switch (filter) {
    case CompareFilter::all: return true;
    case CompareFilter::regressed: return fate == Fate::regressed;
    case CompareFilter::improved: return fate == Fate::improved;
    case CompareFilter::changed: return fate != Fate::same;
  }
  return true;
}

Status colour(Change change) {
  if (change == Change::worse) return Status::fail;
  return change == Change::better ? Status::ok : Status::plain;
}

Cell change_cell(double value, const std::string& text, Change change) {
  Cell cell = number_cell(value, text);
  if (change != Change::same && std::isfinite(value)) cell.status = colour(change);
  return cell;
}

struct Compared {
  Fate fate = Fate::same;
  std::vector<Cell> cells;
};

Compared compare_runs(const Row& before, const Row& now, const CompareOptions& options) {
  const double floor =
      std::max({options.floor * std::max(1.0, unit_roundoff(now.scalar) / unit_roundoff("double")),
                now.truth_floor, now.sensitivity});
  const Change status = judge_status(now.status, before.status);
  const Change error = judge_change(shown_error(now), shown_error(before), options.error_factor, floor);
  const auto work_before = static_cast<double>(before.work.evaluations);
  const auto work_now = static_cast<double>(now.work.evaluations);
  const bool both_ended = now.status == "reached_end" && before.status == "reached_end";
  const Change work =
      both_ended ? judge_change(work_now, work_before, options.evaluations_factor, 0) : Change::same;
  Change time = Change::same;
  double time_ratio = absent;
  if (before.timing && now.timing) {
    const auto &a = *before.timing, &b = *now.timing;
    time_ratio = b.median_seconds / a.median_seconds;
    time = judge_time(b.median_seconds, a.median_seconds, b.mad_seconds, a.mad_seconds, options.time_factor);
  }
  Compared result;
  const auto any = [&](Change c) { return status == c || error == c || work == c || time == c; };
  if (any(Change::worse))
    result.fate = Fate::regressed;
  else if (any(Change::better))
    result.fate = Fate::improved;
  else if (before.status != now.status || before.state_hash != now.state_hash || work_before != work_now)
    result.fate = Fate::changed;

  const double ratio = shown_error(now) / shown_error(before);
  const std::string status_text =
      before.status == now.status ? now.status : fmt::format("{} → {}", before.status, now.status);
  const std::string time_text = time == Change::same && std::isfinite(time_ratio)
                                    ? "~"
                                    : fmt::format("{}x", significant(time_ratio, 3));
  result.cells = {{status_text, colour(status)},
                  number_cell(shown_error(before), scientific(shown_error(before), 3)),
                  number_cell(shown_error(now), scientific(shown_error(now), 3)),
                  change_cell(ratio, fmt::format("{}x", significant(ratio, 3)), error),
                  change_cell(work_now - work_before, fmt::format("{:+.0f}", work_now - work_before), work),
                  change_cell(time_ratio, time_text, time)};
  return result;
}

using Index = std::map<std::string, const Row*>;

Index index_of(const std::vector<Row>& rows) {
  Index index;
  for (const Row& row : rows)
    if (row.status != "not_applicable") index.insert_or_assign(row.id, &row);
  return index;
}

void count_fate(Comparison& comparison, Fate fate) {
  switch (fate) {
    case Fate::same: ++comparison.same; break;
    case Fate::changed: ++comparison.changed; break;
    case Fate::improved: ++comparison.improved; break;
    case Fate::regressed: ++comparison.regressed; break;
  }
}

void add_orders(Table& table, const NamedRows& first, const NamedRows& other, CompareFilter filter,
                const CompareOptions& options) {
  std::map<CurveId, ObservedOrder> before;
  for (auto& order : observed_orders(first.rows)) before.emplace(order.id, std::move(order));
  for (const ObservedOrder& now : observed_orders(other.rows)) {
    const auto found = before.find(now.id);
    if (found == before.end()) continue;
    const double a = found->second.slope.value_or(absent), b = now.slope.value_or(absent);
    Fate fate = Fate::same;
    if (std::isfinite(a) && !(b >= a - options.order_slack))
      fate = Fate::regressed;
    else if (std::isfinite(b) && !(b <= a + options.order_slack))
      fate = Fate::improved;
    if (!is_shown(fate, filter)) continue;
    const auto [word, status] = in_words(fate);
    table.rows.push_back({{case_name(now.id)},
                          {other.name},
                          number_cell(now.claimed, fmt::format("{}", now.claimed)),
                          number_cell(a, fmt::format("{:.2f}", a)),
                          number_cell(b, fmt::format("{:.2f}", b)),
                          number_cell(b - a, fmt::format("{:+.2f}", b - a)),
                          {std::string(word), status}});
  }
}

}  // namespace

Comparison compare(const std::vector<NamedRows>& sets, CompareFilter filter, const CompareOptions& options) {
  if (sets.size() < 2) throw std::invalid_argument("compare needs two results files or more");
  Comparison result;
  const NamedRows& first = sets.front();
  const auto right = Align::right;
  result.runs = {"compare",
                 "Compared with " + first.name,
                 "~: the times differ by less than a factor or their own scatter.",
                 {},
                 {}};
  result.runs.columns = {{"run"},
                         {"in"},
                         {"status"},
                         {"error before", right},
                         {"error now", right},
                         {"error", right},
                         {"evaluations", right},
                         {"time", right},
                         {"verdict"}};
  result.orders = {"compare-orders", "Observed orders", "", {}, {}};
  result.orders.columns = {{"case"},          {"in"},         {"claimed", right},
                           {"before", right}, {"now", right}, {"change", right},
                           {"verdict"}};
  result.one_side = {"compare-one-side", "Runs in one file only", "", {{"run"}, {"only in"}}, {}};

  const Index before = index_of(first.rows);
  for (std::size_t i = 1; i < sets.size(); ++i) {
    const Index now = index_of(sets[i].rows);
    for (const auto& [id, row] : before)
      if (!now.contains(id)) result.one_side.rows.push_back({{id}, {first.name}});
    for (const auto& [id, row] : now) {
      const auto found = before.find(id);
      if (found == before.end()) {
        result.one_side.rows.push_back({{id}, {sets[i].name}});
        continue;
      }
      Compared compared = compare_runs(*found->second, *row, options);
      count_fate(result, compared.fate);
      if (!is_shown(compared.fate, filter)) continue;
      std::vector<Cell> cells{{id}, {sets[i].name}};
      cells.insert(cells.end(), compared.cells.begin(), compared.cells.end());
      const auto [word, status] = in_words(compared.fate);
      cells.push_back({std::string(word), status});
      result.runs.rows.push_back(std::move(cells));
    }
    add_orders(result.orders, first, sets[i], filter, options);
  }
  return result;
}

}  // namespace odemark
