// The demands on one case, each against its runs.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "reports/check.hpp"
#include "reports/check_rules.hpp"

namespace odemark {

/// Collects the runs of one case and metric; the worst outcome is told, equal ones are counted.
class Tally {
 public:
  Tally(const GateCase& gate_case, std::string metric, int line);
  void add(Outcome outcome, std::string message);
  /// Appends the finding; nothing if nothing was added.
  void finish(std::vector<Finding>& findings) const;

 private:
  Finding finding_;
  bool any_ = false;
};

/// What demands with selectors looked for and whether any case had such a run, by line.
struct Sought {
  std::string metric, what;
  bool found = false;
};

struct CaseChecks {
  const Thresholds& thresholds;
  std::vector<Finding>& findings;
  std::map<int, Sought>& sought;
};

/// What it means that a run did not end as demanded: how fast the machine is, is never held against a method,
/// and a contestant that broke down is no reference.
Outcome of_unfinished(const Row& row);

std::string control_in_words(const Row& row);  // "at dt 0.1", "at rtol 1e-06"

/// Everything but the baseline.
void check_demands(const GateCase& gate_case, const Demands& demands, const CaseChecks& checks);

}  // namespace odemark
