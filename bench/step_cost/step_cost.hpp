// Cost per step by Google Benchmark: problem/method/steps:N, achieved error in label and counters.
#pragma once

#include <string>
#include <vector>

#include "bench/registry.hpp"

namespace odemark {

/// Reads Google Benchmark's own flags (all of them work) and `--tax`, the engine's own tax as a table.
/// Returns an exit code: 0, or 2 for an argument that nobody knows.
int step_cost_main(const std::vector<std::string>& arguments, const Registry& registry);

}  // namespace odemark
