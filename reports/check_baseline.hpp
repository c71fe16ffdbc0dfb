// What the gate compares with the baseline, and by which factors.
#pragma once

#include <functional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "reports/baseline.hpp"
#include "reports/check_case.hpp"

namespace odemark {

/// Our own methods always; those of contestants only where a rule says so.
struct BaselineScope {
  bool results = false, evaluations = false;
  double factor = 1, evaluations_factor = 1;
  int line = 0, evaluations_line = 0;
};

BaselineScope scope_of(const GateCase& gate_case, const Demands& demands, const Thresholds& thresholds);

void check_against_baseline(const GateCase& gate_case, const BaselineScope& scope, const Baseline& baseline,
                            bool strict, const CaseChecks& checks);

/// Approved runs that the rows lack. `chosen` says which case names the check is about.
void find_missing_runs(const std::vector<Row>& rows, const Baseline& baseline, const CheckOptions& options,
                       const std::function<bool(const std::string&)>& chosen, const CaseChecks& checks);

}  // namespace odemark
