// Our best against the best of the others: time to an error, on the same problem in the same run.
#pragma once

#include <array>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "reports/cheapest.hpp"

namespace odemark {

inline constexpr double ratio_errors[] = {1e-3, 1e-6, 1e-9, 1e-12};
/// What one would take without looking: a method of ours per class, beside the best of all of ours. The best
/// of a hundred is a choice made after the race.
inline constexpr std::string_view everyday_methods[] = {"tsitouras54", "verner87", "rodas5p", "radau_iia5"};

/// Both sides of one problem and one target error. A side that does not get there has a reason instead.
struct SpeedRatio {
  std::string problem;
  double error = 0;
  std::optional<Offer> own, other;
  std::string own_reason, other_reason;
  std::size_t own_count = 0, other_count = 0;  // codes that get there
  std::array<std::optional<Offer>, std::size(everyday_methods)> everyday;

  std::optional<double> ratio() const;  // own time over the other's; absent where one is missing
};

/// In the order of problems, then of ratio_errors. Problems that were not timed are left out.
std::vector<SpeedRatio> speed_ratios(const std::vector<ProblemCurves>& problems);

Table speed_ratio_table(const std::vector<SpeedRatio>& ratios);

/// True where both sides ran under error control on some problem: the table then says something.
bool compares_codes(const std::vector<ProblemCurves>& problems);

}  // namespace odemark
