// One case against the approved numbers of the same runs, and approved runs that were not run.
#include "reports/check_baseline.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "reports/format.hpp"
#include "reports/numbers.hpp"
#include "reports/verdict.hpp"

namespace odemark {
namespace {

/// Differences below this are round-off in the number type and the truth of the row.
double floor_of(const Row& row, double floor_in_double) {
  double floor = floor_in_double * std::max(1.0, unit_roundoff(row.scalar) / unit_roundoff("double"));
  for (const double bound : {row.truth_floor, row.sensitivity})
    if (bound > floor && std::isfinite(bound)) floor = bound;
  return floor;
}

Outcome outcome_of(Change change) {
  if (change == Change::worse) return Outcome::fail;
  return change == Change::better ? Outcome::improved : Outcome::pass;
}

std::string printed(double x) { return std::isfinite(x) ? scientific(x, 3) : "not finite"; }

void compare_error(Tally& tally, const Row& row, const BaselineRun& before, double factor, double floor) {
  const double now = row.errors ? row.errors->scaled : absent, was = before.scaled.value_or(absent);
  if (std::isnan(now) && std::isnan(was)) return;
  if (row.status == "reached_end" && !row.errors) {
    tally.add(Outcome::no_reference, fmt::format("no reference solution {} ({}), baseline {}",
                                                 control_in_words(row), row.reason, printed(was)));
    return;
  }
  const Outcome outcome = outcome_of(judge_change(now, was, factor, floor));
  std::string message = fmt::format("error {} {}, baseline {}, allowed {:g}x", printed(now),
                                    control_in_words(row), printed(was), factor);
  if (outcome == Outcome::improved)
    message = fmt::format("error {} {}, {}x baseline: improved, run `odemark approve --only '{}/{}'`",
                          printed(now), control_in_words(row),
                          std::isnan(was) ? std::string("no") : fmt::format("{:.2g}", now / was), row.problem,
                          row.method);
  tally.add(outcome, message);
}

void compare_drift(Tally& tally, const Row& row, const BaselineRun& before, double factor, double floor) {
  for (const auto& [name, was] : before.drift) {
    const auto found = row.drift.find(name);
    const double now = found == row.drift.end() ? absent : found->second;
    if (std::isnan(now) && std::isnan(was)) continue;
    tally.add(outcome_of(judge_change(now, was, factor, floor)),
              fmt::format("{} drifts by {} {}, baseline {}, allowed {:g}x", name, printed(now),
                          control_in_words(row), printed(was), factor));
  }
}

void compare_evaluations(Tally& tally, const Row& row, const BaselineRun& before, double factor) {
  const auto now = static_cast<double>(row.work.evaluations), was = static_cast<double>(before.evaluations);
  tally.add(outcome_of(judge_change(now, was, factor, 0)),
            fmt::format("{} evaluations {}, baseline {}, allowed {:g}x", row.work.evaluations,
                        control_in_words(row), before.evaluations, factor));
}

void compare_hash(Tally& tally, const Row& row, const BaselineRun& before) {
  if (before.state_hash.empty())
    tally.add(Outcome::missing, "the baseline has no state hash: approve anew");
  else
    tally.add(row.state_hash == before.state_hash ? Outcome::pass : Outcome::fail,
              fmt::format("final state {} {}, baseline {}", row.state_hash, control_in_words(row),
                          before.state_hash));
}

void compare_order(const GateCase& gate_case, const Baseline& baseline, const Thresholds& thresholds,
                   std::vector<Finding>& findings) {
  const auto before = baseline.orders.find(gate_case.name);
  if (before == baseline.orders.end()) return;
  std::vector<Row> curve;
  for (const Row* row : gate_case.executed)
    if (row->steps) curve.push_back(*row);
  const ObservedOrder order = observed_order(curve);
  const double slack = thresholds.defaults.order_slack;
  Tally tally(gate_case, "baseline order", 0);
  const bool met = order.slope && *order.slope >= before->second - slack;
  tally.add(met ? Outcome::pass : Outcome::fail,
            order.slope ? fmt::format("order {:.2f}, baseline {:.2f}, may be {:g} less", *order.slope,
                                      before->second, slack)
                        : fmt::format("order {:.2f} in the baseline, now {}", before->second, order.reason));
  tally.finish(findings);
}

}  // namespace

BaselineScope scope_of(const GateCase& gate_case, const Demands& demands, const Thresholds& thresholds) {
  BaselineScope scope;
  const bool own = gate_case.provider == "odemark";
  scope.results = own || demands.baseline;
  scope.evaluations = own || demands.evaluations;
  scope.factor = demands.baseline ? demands.baseline.demand->factor : thresholds.defaults.baseline_factor;
  scope.line = demands.baseline ? demands.baseline.demand->line : 0;
  scope.evaluations_factor =
      demands.evaluations ? demands.evaluations.demand->factor : thresholds.defaults.evaluations_factor;
  scope.evaluations_line = demands.evaluations ? demands.evaluations.demand->line : 0;
  return scope;
}

void check_against_baseline(const GateCase& gate_case, const BaselineScope& scope, const Baseline& baseline,
                            bool strict, const CaseChecks& checks) {
  if (!scope.results && !scope.evaluations) return;
  Tally status(gate_case, "baseline status", scope.line), error(gate_case, "baseline error", scope.line);
  Tally drift(gate_case, "baseline drift", scope.line), bits(gate_case, "state_hash", 0);
  Tally evaluations(gate_case, "evaluations", scope.evaluations_line), fresh(gate_case, "baseline", 0);
  std::vector<const Row*> all = gate_case.executed;
  all.insert(all.end(), gate_case.blank.begin(), gate_case.blank.end());
  bool any_known = false;
  for (const Row* row : all) {
    const auto found = baseline.runs.find(row->id);
    if (found == baseline.runs.end()) {
      if (row->status != "not_applicable")
        fresh.add(Outcome::note, fmt::format("not in the baseline yet {}", control_in_words(*row)));
      continue;
    }
    const BaselineRun& before = found->second;
    const double floor = floor_of(*row, checks.thresholds.defaults.floor);
    any_known = true;
    const Change change = judge_status(row->status, before.status);
    if (scope.results)
      status.add(change == Change::worse ? of_unfinished(*row) : outcome_of(change),
                 fmt::format("{} {}, baseline {}", row->status, control_in_words(*row), before.status));
    if (change != Change::same) continue;
    if (scope.results) compare_error(error, *row, before, scope.factor, floor);
    if (scope.results && row->status == "reached_end")
      compare_drift(drift, *row, before, scope.factor, floor);
    if (scope.evaluations && row->status == "reached_end")
      compare_evaluations(evaluations, *row, before, scope.evaluations_factor);
    if (strict && scope.results) compare_hash(bits, *row, before);
  }
  for (const Tally* tally : {&status, &error, &drift, &evaluations, &bits, &fresh})
    tally->finish(checks.findings);
  if (scope.results && any_known) compare_order(gate_case, baseline, checks.thresholds, checks.findings);
}

void find_missing_runs(const std::vector<Row>& rows, const Baseline& baseline, const CheckOptions& options,
                       const std::function<bool(const std::string&)>& chosen, const CaseChecks& checks) {
  std::set<std::string_view> run;
  for (const Row& row : rows) run.insert(row.id);
  std::map<std::string, Tally> tallies;
  for (const auto& [id, before] : baseline.runs) {
    if (run.contains(id) || !chosen(before.case_name)) continue;
    const GateCase gate_case = blank_case(parse_case_name(before.case_name), before.provider);
    const Demands demands = demands_on(gate_case, checks.thresholds, options.today);
    const BaselineScope scope = scope_of(gate_case, demands, checks.thresholds);
    if (demands.skipped || (!scope.results && !scope.evaluations)) continue;
    tallies.try_emplace(before.case_name, gate_case, "baseline", 0)
        .first->second.add(Outcome::missing, fmt::format("in the baseline but not run: {}", id));
  }
  for (const auto& [name, tally] : tallies) tally.finish(checks.findings);
}

}  // namespace odemark
