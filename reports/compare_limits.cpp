// Matching by problem, method and number type: unstable is less than a limit, a limit less than none.
#include "reports/compare_limits.hpp"

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <string>

#include "reports/compare_fate.hpp"
#include "reports/format.hpp"

namespace odemark {
namespace {

constexpr double same_limit = 1e-6;  // relative; what the gate allows against theory

using LimitIndex = std::map<std::string, const StabilityRow*>;

LimitIndex limits_by_id(const std::vector<StabilityRow>& rows) {
  LimitIndex index;
  for (const StabilityRow& row : rows)
    if (row.verdict != "blank")
      index.insert_or_assign(fmt::format("stability/{}/{}/{}", row.problem, row.method, row.scalar), &row);
  return index;
}

int rank_of_limit(const StabilityRow& row) {
  return row.verdict == "unlimited" ? 2 : row.verdict == "limit" ? 1 : 0;
}

Fate fate_of_limit(const StabilityRow& before, const StabilityRow& now) {
  if (now.failure.empty() != before.failure.empty())
    return now.failure.empty() ? Fate::improved : Fate::regressed;
  if (rank_of_limit(now) != rank_of_limit(before))
    return rank_of_limit(now) > rank_of_limit(before) ? Fate::improved : Fate::regressed;
  if (now.measured && before.measured) {
    const double moved = *now.measured - *before.measured;
    // so that NaN is not the same
    if (!(std::abs(moved) <= same_limit * *before.measured + now.resolution + before.resolution))
      return moved > 0 ? Fate::improved : Fate::regressed;
  } else if (now.measured.has_value() != before.measured.has_value()) {
    return Fate::changed;
  }
  return now.later_bands == before.later_bands ? Fate::same : Fate::changed;
}

std::string limit_in_words(const StabilityRow& row) {
  if (!row.failure.empty()) return row.failure;
  return row.verdict == "limit" && row.measured ? significant(*row.measured, 7) : row.verdict;
}

}  // namespace

void compare_limits(Comparison& comparison, const NamedRows& before, const NamedRows& now,
                    CompareFilter filter) {
  const LimitIndex old_rows = limits_by_id(before.stability), new_rows = limits_by_id(now.stability);
  for (const auto& [id, row] : old_rows)
    if (!new_rows.contains(id)) comparison.one_side.rows.push_back({{id}, {before.name}});
  for (const auto& [id, row] : new_rows) {
    const auto found = old_rows.find(id);
    if (found == old_rows.end()) {
      comparison.one_side.rows.push_back({{id}, {now.name}});
      continue;
    }
    const Fate fate = fate_of_limit(*found->second, *row);
    count_fate(comparison, fate);
    if (!is_shown(fate, filter)) continue;
    const auto [word, status] = in_words(fate);
    comparison.limits.rows.push_back({{id},
                                      {now.name},
                                      {limit_in_words(*found->second)},
                                      {limit_in_words(*row)},
                                      {std::string(word), status}});
  }
}

}  // namespace odemark
