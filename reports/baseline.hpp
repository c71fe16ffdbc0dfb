// baseline.json: the numbers of an approved run. Only `approve` writes it, with a reason; people review its
// diff.
#pragma once

#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "bench/data/row.hpp"
#include "reports/observed_order.hpp"
#include "reports/table.hpp"

namespace odemark {

inline constexpr int baseline_schema = 2;

struct BaselineRun {
  std::string case_name;             // "kepler_e06/rk4"; " [float]" where not plain double
  std::string provider = "odemark";  // of the method
  std::string status;
  std::optional<double> scaled;  // error
  long evaluations = 0, accepted = 0, rejected = 0;
  std::map<std::string, double> drift;  // NaN: was not finite
  std::string state_hash;
};

struct Baseline {
  std::string tool, compiler, flags, build_type, reason;
  std::map<std::string, double> orders;     // case name -> observed order, where it was measurable
  std::map<std::string, BaselineRun> runs;  // by row id
};

/// Cut, of another schema, or no baseline at all: one sentence.
struct BadBaseline : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Sorted, one ladder a line: equal baselines are equal bytes.
std::string to_text(const Baseline& baseline);
/// Throws BadBaseline.
Baseline parse_baseline(std::string_view text, std::string_view name = "baseline.json");

/// Everything that was executed, in six digits; the text of baseline.received.json, and what approve starts
/// from.
Baseline make_baseline(const std::vector<Row>& rows, const RunHeader& header, std::string reason);

struct Approval {
  std::string text;  // of the new baseline.json
  Table changes;     // one row per run that is new, gone or different
  int added = 0, removed = 0, changed = 0;
};

/// `only` is a regular expression on case names; runs of other cases stay as they are. Throws
/// std::invalid_argument for a blank reason, a bad expression, or an expression that no case matches.
Approval approve(const std::vector<Row>& rows, const RunHeader& header, const std::optional<Baseline>& old,
                 std::string_view reason, std::string_view only = "");

}  // namespace odemark
