// From rows to cases to findings to an exit code.
#include "reports/check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <regex>
#include <set>

#include "reports/check_baseline.hpp"

namespace odemark {
namespace {

std::vector<GateCase> cases_of(const std::vector<Row>& rows, const std::vector<StabilityRow>& stability) {
  std::vector<GateCase> cases;
  std::map<CurveId, std::size_t> index;
  const auto case_of = [&](const CurveId& id, const std::string& provider) -> GateCase& {
    const auto [at, is_new] = index.emplace(id, cases.size());
    if (is_new) cases.push_back(blank_case(id, provider));
    return cases[at->second];
  };
  for (const Row& row : rows) {
    GateCase& gate_case = case_of(curve_of(row), row.provider);
    (row.status == "not_applicable" ? gate_case.blank : gate_case.executed).push_back(&row);
  }
  for (const StabilityRow& row : stability)
    case_of({row.problem, row.method, row.scalar, false}, row.provider).stability.push_back(&row);
  return cases;
}

Finding about_file(std::string name, std::string metric, Outcome outcome, std::string message, int line = 0) {
  Finding finding;
  finding.case_name = finding.problem = std::move(name), finding.metric = std::move(metric);
  finding.outcome = outcome, finding.message = std::move(message), finding.line = line;
  return finding;
}

bool is_about(const Finding& finding, const GateCase& gate_case) {
  return finding.case_name == gate_case.name && finding.outcome != Outcome::skipped &&
         finding.outcome != Outcome::missing && finding.outcome != Outcome::no_reference &&
         finding.metric != "baseline";
}

void note_other_build(CheckResult& result, const Baseline& baseline, const RunHeader& header) {
  if (header.compiler.empty() || (baseline.compiler == header.compiler && baseline.flags == header.flags))
    return;
  result.findings.push_back(about_file(result.baseline_name, "build", Outcome::note,
                                       fmt::format("approved with {} {}, run with {} {}", baseline.compiler,
                                                   baseline.flags, header.compiler, header.flags)));
}

}  // namespace

std::string_view to_string(Outcome outcome) {
  switch (outcome) {
    case Outcome::pass: return "pass";
    case Outcome::note: return "note";
    case Outcome::improved: return "improved";
    case Outcome::skipped: return "skipped";
    case Outcome::missing: return "missing";
    case Outcome::no_reference: return "no reference";
    case Outcome::fail: return "fail";
  }
  return "unknown";
}

BaselineFile load_baseline(const std::optional<std::string>& text, std::string_view name) {
  BaselineFile file;
  file.name = name;
  if (!text) {
    file.problem = fmt::format("there is no {}: run `odemark approve --reason \"...\"` first", name);
    return file;
  }
  try {
    file.baseline = parse_baseline(*text, name);
  } catch (const BadBaseline& e) {
    file.problem = e.what();
    file.damaged = true;
  }
  return file;
}

CheckResult check(const std::vector<Row>& rows, const std::vector<StabilityRow>& stability,
                  const Thresholds& thresholds, const BaselineFile& baseline, const RunHeader& header,
                  const CheckOptions& options) {
  std::regex only;
  try {
    only = std::regex(options.only);
  } catch (const std::regex_error&) {
    throw std::invalid_argument(fmt::format("\"{}\" is no regular expression", options.only));
  }
  const auto chosen = [&](const std::string& name) {
    return options.only.empty() || std::regex_search(name, only);
  };
  if (baseline.damaged || (options.baseline_named && !baseline.baseline))
    throw std::invalid_argument(baseline.problem);
  CheckResult result;
  result.thresholds_name = thresholds.name, result.baseline_name = baseline.name;
  const auto cases = cases_of(rows, stability);
  const auto unmatched = unmatched_globs(thresholds, cases);
  std::map<int, Sought> sought;
  const CaseChecks checks{thresholds, result.findings, sought};

  for (const GateCase& gate_case : cases) {
    if (!chosen(gate_case.name)) continue;
    const Demands demands = demands_on(gate_case, thresholds, options.today);
    const std::size_t before = result.findings.size();
    if (gate_case.was_run()) ++result.executed;
    if (demands.skipped) {
      Tally tally(gate_case, "skip", demands.skip_line);
      if (gate_case.was_run()) tally.add(Outcome::skipped, demands.skip_reason);
      tally.finish(result.findings);
      continue;
    }
    check_demands(gate_case, demands, checks);
    if (baseline.baseline)
      check_against_baseline(gate_case, scope_of(gate_case, demands, thresholds), *baseline.baseline,
                             options.strict, checks);
    if (!gate_case.was_run()) ++result.not_applicable;
    if (gate_case.was_run() &&
        std::any_of(result.findings.begin() + static_cast<std::ptrdiff_t>(before), result.findings.end(),
                    [&](const Finding& f) { return is_about(f, gate_case); }))
      ++result.compared;
  }

  if (baseline.baseline) {
    find_missing_runs(rows, *baseline.baseline, options, chosen, checks);
    note_other_build(result, *baseline.baseline, header);
  } else if (thresholds.defaults.needs_baseline || options.strict || !baseline.problem.empty()) {
    const bool needed = thresholds.defaults.needs_baseline || options.strict;
    result.findings.push_back(about_file(baseline.name.empty() ? "baseline.json" : baseline.name, "baseline",
                                         needed ? Outcome::missing : Outcome::note, baseline.problem));
  }
  if (options.only.empty()) {
    for (const auto& [glob, rule] : unmatched)
      result.findings.push_back(about_file(
          glob, "rule", rule->optional ? Outcome::note : Outcome::missing,
          rule->optional ? "the optional rule matches no executed case"
                         : "the rule matches no executed case: run one, or say optional = true in the rule",
          rule->line));
    for (const auto& [line, what] : sought)
      if (!what.found)
        result.findings.push_back(about_file(thresholds.name, what.metric, Outcome::missing,
                                             fmt::format("no case of the rule has a {}", what.what), line));
  }
  return result;
}

int count(const CheckResult& result, Outcome outcome) {
  return static_cast<int>(std::count_if(result.findings.begin(), result.findings.end(),
                                        [&](const Finding& f) { return f.outcome == outcome; }));
}

int exit_code(const CheckResult& result) {
  if (count(result, Outcome::fail) > 0) return 1;
  if (count(result, Outcome::no_reference) > 0) return 4;
  return count(result, Outcome::missing) > 0 || result.compared == 0 ? 3 : 0;
}

}  // namespace odemark
