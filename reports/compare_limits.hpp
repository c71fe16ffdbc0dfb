// The stability limits of two results files side by side.
#pragma once

#include <vector>

#include "bench/data/stability.hpp"
#include "reports/compare.hpp"

namespace odemark {

/// Into the limits, the counts and what only one side has. A limit that moved by less than a part of it and
/// both resolutions is no better and no worse.
void compare_limits(Comparison& comparison, const NamedRows& before, const NamedRows& now,
                    CompareFilter filter);

}  // namespace odemark
