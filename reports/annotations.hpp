// A check as workflow commands of GitHub Actions: marks on the lines of thresholds.toml.
#pragma once

#include <string>

#include "reports/check.hpp"

namespace odemark {

/// One line per finding worth a mark; empty if all is well. `path` is thresholds.toml as the repository has
/// it; empty: the name it was read by.
std::string to_github(const CheckResult& result, std::string path = "");

}  // namespace odemark
