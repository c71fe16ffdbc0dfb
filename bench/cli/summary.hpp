// What the console shows after a run: a dozen lines of what was found.
#pragma once

#include <string>

#include "bench/json_line.hpp"

namespace odemark {

/// Per problem (the first ones) a few rows: error at two dts, measured order, time to 1e-6; then the counts.
std::string console_summary(const Results& results);

}  // namespace odemark
