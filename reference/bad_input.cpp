#include "reference/bad_input.hpp"

#include <algorithm>
#include <numeric>

namespace odemark {

namespace {

std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, replaced});
    }
  }
  return row.back();
}

}  // namespace

std::string suggestion(std::string_view typed, const std::vector<std::string>& candidates) {
  const std::string* best = nullptr;
  std::size_t closest = std::max<std::size_t>(2, typed.size() / 3) + 1;
  for (const auto& candidate : candidates) {
    std::size_t distance = edit_distance(typed, candidate);
    // "dopri" or "verlet" is meant for a longer name that contains it
    if (typed.size() >= 3 && candidate.find(typed) != candidate.npos)
      distance = std::min<std::size_t>(distance, 1);
    if (distance < closest) closest = distance, best = &candidate;
  }
  return best ? " (did you mean \"" + *best + "\"?)" : "";
}

}  // namespace odemark
