// The gate: rows against what people demand and against the approved baseline. One function decides; console,
// files and exit code only repeat it.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bench/data/row.hpp"
#include "bench/data/stability.hpp"
#include "reports/baseline.hpp"
#include "reports/thresholds.hpp"

namespace odemark {

/// From best to worst: of several of one case and metric the worst is told.
enum class Outcome { pass, note, improved, skipped, missing, no_reference, fail };

std::string_view to_string(Outcome outcome);

/// One case and one metric.
struct Finding {
  std::string case_name;        // "kepler_e06/rk4"; the glob of a rule that matched nothing; "baseline"
  std::string problem, method;  // with " [float]" in the method where it is not plain double
  std::string metric;           // "order", "error", "drift", "status", "stability", "baseline error", ...
  Outcome outcome = Outcome::pass;
  std::string message;  // measured and allowed
  int line = 0;         // of the demand in the thresholds; 0: a default
  int others = 0;       // runs of the same case and metric with the same outcome
};

struct CheckOptions {
  bool strict = false;  // final states must equal the baseline's bit for bit
  std::string today{};  // YYYY-MM-DD: skips past their `until` end; empty: none does
  std::string only{};   // regular expression on case names; throws std::invalid_argument if it is none
  bool baseline_named = false;  // by the user: then it must be there
};

/// A baseline that may be absent or damaged; `problem` then says why in one sentence.
struct BaselineFile {
  std::optional<Baseline> baseline;
  std::string name, problem;
  bool damaged = false;
};

/// Never throws: what is wrong with the text becomes `problem`. No text: the file is absent.
BaselineFile load_baseline(const std::optional<std::string>& text, std::string_view name = "baseline.json");

struct CheckResult {
  std::string thresholds_name, baseline_name;
  int executed = 0, compared = 0;  // cases
  int not_applicable = 0;          // cases that no run could be made of
  std::vector<Finding> findings;   // in the order of the rows; passes included
};

/// Throws BadThresholds where a rule names a case that was not run, std::invalid_argument for a damaged
/// baseline and for one that the user named and that is not there.
CheckResult check(const std::vector<Row>& rows, const std::vector<StabilityRow>& stability,
                  const Thresholds& thresholds, const BaselineFile& baseline, const RunHeader& header = {},
                  const CheckOptions& options = {});

int count(const CheckResult& result, Outcome outcome);

/// 0 ok; 1 something is violated; 4 no reference where one was needed; 3 incomplete or nothing was compared.
/// 2, a configuration error, is BadThresholds or std::invalid_argument.
int exit_code(const CheckResult& result);

// Texts of a result. None is empty; all end in a newline.
std::string to_console(const CheckResult& result);
std::string to_markdown(const CheckResult& result);  // at most 900 kB, failures first
std::string to_json(const CheckResult& result);

}  // namespace odemark
