// A check as JUnit XML: one test case per case and metric, for any continuous integration.
#pragma once

#include <string>

#include "reports/check.hpp"

namespace odemark {

std::string to_junit(const CheckResult& result);

}  // namespace odemark
