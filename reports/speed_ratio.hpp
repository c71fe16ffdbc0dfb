// Our best against the best of the others: time to an error, on the same problem in the same run.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "reports/cheapest.hpp"

namespace odemark {

inline constexpr double ratio_errors[] = {1e-3, 1e-6, 1e-9, 1e-12};

/// Both sides of one problem and one target error. A side that does not get there has a reason instead.
struct SpeedRatio {
  std::string problem;
  double error = 0;
  std::optional<Offer> own, other;
  std::string own_reason, other_reason;

  std::optional<double> ratio() const;  // own time over the other's; absent where one is missing
};

/// In the order of problems, then of ratio_errors. Problems that were not timed are left out.
std::vector<SpeedRatio> speed_ratios(const std::vector<ProblemCurves>& problems);

Table speed_ratio_table(const std::vector<SpeedRatio>& ratios);

/// True where both sides ran under error control on some problem: the table then says something.
bool compares_codes(const std::vector<ProblemCurves>& problems);

}  // namespace odemark
