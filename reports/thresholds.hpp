// thresholds.toml: what people demand of methods on problems. Written by people, never by the tool.
#pragma once

#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace odemark {

/// One sentence with file and line: a file that cannot mean what its author wanted.
struct BadThresholds : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Which runs of a case a demand is about.
struct RunSelector {
  enum class Kind { every, finest, at_dt, up_to_dt, from_dt, at_steps, at_tol };
  Kind kind = Kind::every;
  double value = 0;
};

/// `order = "claimed"` or `{ min = 3.8, max = 4.2, inconclusive = "fail" }`
struct OrderDemand {
  int line = 0;
  bool off = false;
  bool claimed = false;  // at least the claimed order - slack, no upper bound
  std::optional<double> min, max;
  bool inconclusive_fails = true;
};

/// `error = { at_dt = 0.1, max = 1e-6, norm = "scaled" }`, or a list of them
struct ErrorDemand {
  int line = 0;
  RunSelector runs;
  double max = 0;
  std::string norm = "scaled";
};

/// `drift = { invariant = "energy", max = 1e-3 }`, or a list of them
struct DriftDemand {
  int line = 0;
  RunSelector runs;
  std::string invariant;
  double max = 0;
};

/// `status = "reached_end"` or `{ is = ["not_finite", "step_limit"], at_dt = 2.5 }`
struct StatusDemand {
  int line = 0;
  bool off = false;
  RunSelector runs;
  std::vector<std::string> expected;
};

/// A factor against the baseline: `evaluations = { max_factor = 1.1 }`, `baseline_factor = 1.5`
struct FactorDemand {
  int line = 0;
  double factor = 1;
};

/// `stability = { rel = 1e-6 }`: the measured limit agrees with theory
struct StabilityDemand {
  int line = 0;
  bool off = false;
  double relative = 0;
};

/// `stability_verdict = "unstable"`
struct StabilityVerdictDemand {
  int line = 0;
  bool off = false;
  std::string verdict;
};

/// One [[rule]]. The last rule that matches a case decides each demand.
struct Rule {
  int line = 0;
  std::vector<std::string> cases;    // globs on "problem/method"
  std::string provider = "odemark";  // glob
  std::string scalar = "double";     // glob
  bool compensated = false;
  bool optional = false;  // it may match nothing that was run

  std::optional<bool> skip;
  std::string reason, until;  // of the skip; until is YYYY-MM-DD, the last day on which it is skipped

  std::optional<OrderDemand> order;
  std::optional<std::vector<ErrorDemand>> error;  // empty: off
  std::optional<std::vector<DriftDemand>> drift;
  std::optional<StatusDemand> status;
  std::optional<FactorDemand> evaluations, baseline;
  std::optional<StabilityDemand> stability;
  std::optional<StabilityVerdictDemand> stability_verdict;
};

struct Defaults {
  double baseline_factor = 1.5, evaluations_factor = 1.1;
  double floor = 1e-13;  // in double; wider in float, as the unit roundoff is
  double order_slack = 0.3;
  std::optional<StatusDemand> require_status;
  bool needs_baseline = false;  // the file speaks of a baseline somewhere
};

struct Thresholds {
  std::string name = "thresholds.toml";
  Defaults defaults;
  std::vector<Rule> rules;
};

inline constexpr int thresholds_schema = 1;

/// Throws BadThresholds for anything that is not understood to the last key.
Thresholds parse_thresholds(std::string_view toml, std::string_view name = "thresholds.toml");

/// '*' is any text, '?' any one character; nothing else is special.
bool matches_glob(std::string_view glob, std::string_view text);
bool is_glob(std::string_view text);

}  // namespace odemark
