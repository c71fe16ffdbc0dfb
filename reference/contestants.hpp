// The third-party solvers that were compiled in, behind the same interface as the suite's own methods.
#pragma once

#include <string>

#include "integrators/any_method.hpp"

namespace odemark {

/// Every contestant of every provider found when the suite was built.
std::vector<AnyMethod> contestants();

struct ProviderInfo {
  std::string_view name;  // AnyMethod::provider
  std::string version;
  std::string built;  // compiled optimised or not, measured where it can be
};

std::vector<ProviderInfo> contestant_providers();

}  // namespace odemark
