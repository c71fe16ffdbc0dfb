// The third-party solvers that were compiled in, behind the same interface as the suite's own methods.
#pragma once

#include <string>

#include "integrators/any_method.hpp"

namespace odemark {

/// Every contestant of every provider found when the suite was built.
std::vector<AnyMethod> contestants();

/// A contestant with one family's right-hand side inlined, under error control, where its library allows
/// that.
struct InlinedContestant {
  std::string_view family, method;
  RunReport (*solve)(const void* values, const Control&, double t0, double t1, double* y);
};
std::vector<InlinedContestant> inlined_contestants();

struct ProviderInfo {
  std::string_view name;  // AnyMethod::provider
  std::string version;
  std::string built;  // compiled optimised or not, measured where it can be
};

std::vector<ProviderInfo> contestant_providers();

}  // namespace odemark
