// Which demands hold for one case: the last matching rule of each.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "bench/data/row.hpp"
#include "bench/data/stability.hpp"
#include "reports/observed_order.hpp"
#include "reports/thresholds.hpp"

namespace odemark {

/// All runs of one method on one problem in one number type.
struct GateCase {
  CurveId id;
  std::string name, provider;
  std::vector<const Row*> executed, blank;  // blank: not applicable
  std::vector<const StabilityRow*> stability;
  bool was_run() const;  // something was measured
};

GateCase blank_case(const CurveId& id, const std::string& provider);
/// The inverse of case_name().
CurveId parse_case_name(std::string_view name);

/// A demand and whether its rule names this very case (no wildcard).
template <class T>
struct Chosen {
  const T* demand = nullptr;
  bool named = false;
  explicit operator bool() const { return demand != nullptr; }
};

struct Demands {
  bool skipped = false;
  std::string skip_reason;
  int skip_line = 0;
  Chosen<OrderDemand> order;
  Chosen<std::vector<ErrorDemand>> error;
  Chosen<std::vector<DriftDemand>> drift;
  Chosen<StatusDemand> status;
  Chosen<StabilityDemand> stability;
  Chosen<StabilityVerdictDemand> stability_verdict;
  Chosen<FactorDemand> evaluations, baseline;
};

bool matches(const Rule& rule, const GateCase& gate_case);
Demands demands_on(const GateCase& gate_case, const Thresholds& thresholds, const std::string& today);

/// The runs a selector means.
std::vector<const Row*> select_runs(const GateCase& gate_case, const RunSelector& runs);
std::string in_words(const RunSelector& runs);

/// A part of a rule's `case` that matched no executed case.
struct Unmatched {
  std::string glob;
  const Rule* rule;
};

/// Throws BadThresholds for one without wildcards whose rule is not optional.
std::vector<Unmatched> unmatched_globs(const Thresholds& thresholds, const std::vector<GateCase>& cases);

}  // namespace odemark
