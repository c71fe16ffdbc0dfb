// What a console shows after a run: a dozen lines of what was found.
#pragma once

#include <string>
#include <vector>

#include "bench/data/row.hpp"
#include "bench/data/stability.hpp"

namespace odemark {

/// One or two methods per problem (the first ones): error at two dts, measured order, cost of 1e-6; then the
/// counts.
std::string console_summary(const std::vector<Row>& rows, const std::vector<StabilityRow>& stability);

}  // namespace odemark
