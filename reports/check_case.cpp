// Each demand is written so that NaN and absent values take the failing side.
#include "reports/check_case.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "reports/format.hpp"
#include "reports/numbers.hpp"
#include "reports/verdict.hpp"

namespace odemark {
namespace {

double norm_of(const RowErrors& e, std::string_view norm) {
  if (norm == "absolute") return e.absolute;
  if (norm == "relative") return e.relative.value_or(absent);
  if (norm == "rms") return e.rms;
  if (norm == "trajectory_max") return e.trajectory_max.value_or(absent);
  if (norm == "trajectory_rms") return e.trajectory_rms.value_or(absent);
  if (norm == "amplitude") return std::abs(e.amplitude.value_or(absent));
  if (norm == "phase") return std::abs(e.phase.value_or(absent));
  return e.scaled;
}

std::string because(const Row& row) { return row.reason.empty() ? "" : fmt::format(" ({})", row.reason); }

/// Remembers that a demand looked for something and whether it was there; tells it at once if the rule names
/// the case.
void remember(const GateCase& gate_case, const char* metric, int line, bool named, bool found,
              const std::string& what, const CaseChecks& checks) {
  Sought& sought = checks.sought[line];
  sought.metric = metric, sought.what = what;
  if (found || named) sought.found = true;
  if (found || !named) return;
  Tally tally(gate_case, metric, line);
  tally.add(Outcome::missing, fmt::format("no {}", what));
  tally.finish(checks.findings);
}

std::vector<const Row*> runs_for(const GateCase& gate_case, const RunSelector& runs, const char* metric,
                                 int line, bool named, const CaseChecks& checks) {
  auto found = select_runs(gate_case, runs);
  remember(gate_case, metric, line, named, !found.empty(), "run " + in_words(runs), checks);
  return found;
}

void check_order(const GateCase& gate_case, const Chosen<OrderDemand>& chosen, const CaseChecks& checks) {
  const OrderDemand& demand = *chosen.demand;
  std::vector<Row> curve;
  bool reached = false, has_error = false;
  for (const Row* row : gate_case.executed)
    if (row->steps) {
      curve.push_back(*row);
      reached = reached || row->status == "reached_end";
      has_error = has_error || row->errors.has_value();
    }
  remember(gate_case, "order", demand.line, chosen.named, !curve.empty(), "run with fixed steps", checks);
  if (curve.empty()) return;  // chooses its own steps
  Tally tally(gate_case, "order", demand.line);
  OrderOptions options;
  options.slack = checks.thresholds.defaults.order_slack;
  const ObservedOrder order = observed_order(curve, options);
  if (demand.claimed && order.claimed == 0 && !order.because.empty()) {
    tally.add(Outcome::note, fmt::format("no order is to be expected: {}", order.because));
    tally.finish(checks.findings);
    return;
  }
  if (!order.slope) {
    const Outcome outcome = reached && !has_error       ? Outcome::no_reference
                            : demand.inconclusive_fails ? Outcome::fail
                                                        : Outcome::note;
    tally.add(outcome, fmt::format("order inconclusive: {}", order.reason));
    tally.finish(checks.findings);
    return;
  }
  const double lowest = demand.claimed ? order.claimed - options.slack
                                       : demand.min.value_or(-std::numeric_limits<double>::infinity());
  const std::string window =
      fmt::format("on dt {:.3g} to {:.3g}, {} rungs", *order.dt_max, *order.dt_min, order.points);
  std::string why = demand.claimed && !order.reason.empty() ? "; " + order.reason : "";
  if (demand.claimed && !order.because.empty())
    why +=
        fmt::format("; {} instead of {} is expected, because {}", order.claimed, order.stated, order.because);
  if (!(*order.slope >= lowest))
    tally.add(Outcome::fail, fmt::format("order {:.2f} < {:.2f} {}{}", *order.slope, lowest, window, why));
  else if (demand.max && !(*order.slope <= *demand.max))
    tally.add(Outcome::fail, fmt::format("order {:.2f} > {:.2f} {}", *order.slope, *demand.max, window));
  else
    tally.add(demand.claimed && order.verdict == OrderVerdict::exceeds ? Outcome::note : Outcome::pass,
              fmt::format("order {:.2f} {}{}", *order.slope, window, why));
  tally.finish(checks.findings);
}

void check_error(const GateCase& gate_case, const Chosen<std::vector<ErrorDemand>>& chosen,
                 const CaseChecks& checks) {
  for (const ErrorDemand& demand : *chosen.demand) {
    Tally tally(gate_case, "error", demand.line);
    for (const Row* row : runs_for(gate_case, demand.runs, "error", demand.line, chosen.named, checks)) {
      const std::string where = control_in_words(*row);
      if (row->status != "reached_end") {
        tally.add(of_unfinished(*row), fmt::format("no error {}: {}{}", where, row->status, because(*row)));
        continue;
      }
      if (!row->errors) {
        tally.add(Outcome::no_reference, fmt::format("no reference solution {}{}", where, because(*row)));
        continue;
      }
      const double value = norm_of(*row->errors, demand.norm);
      if (std::isnan(value))
        tally.add(Outcome::fail, fmt::format("{} error is not a number or absent {}", demand.norm, where));
      else
        tally.add(value <= demand.max ? Outcome::pass : Outcome::fail,
                  fmt::format("{} error {} {} {} {}", demand.norm, scientific(value, 3),
                              value <= demand.max ? "<=" : ">", compact(demand.max, 6), where));
    }
    tally.finish(checks.findings);
  }
}

void check_drift(const GateCase& gate_case, const Chosen<std::vector<DriftDemand>>& chosen,
                 const CaseChecks& checks) {
  for (const DriftDemand& demand : *chosen.demand) {
    Tally tally(gate_case, "drift", demand.line);
    for (const Row* row : runs_for(gate_case, demand.runs, "drift", demand.line, chosen.named, checks)) {
      const std::string where = control_in_words(*row);
      const auto found = row->drift.find(demand.invariant);
      if (row->status != "reached_end")
        tally.add(of_unfinished(*row), fmt::format("no drift {}: {}{}", where, row->status, because(*row)));
      else if (found == row->drift.end())
        tally.add(Outcome::fail, fmt::format("{} is no invariant of {}", demand.invariant, row->problem));
      else
        tally.add(found->second <= demand.max ? Outcome::pass : Outcome::fail,
                  fmt::format("{} drifts by {} {} {} {}", demand.invariant, scientific(found->second, 3),
                              found->second <= demand.max ? "<=" : ">", compact(demand.max, 6), where));
    }
    tally.finish(checks.findings);
  }
}

void check_status(const GateCase& gate_case, const Chosen<StatusDemand>& chosen, const CaseChecks& checks) {
  const StatusDemand& demand = *chosen.demand;
  const auto& defaults = checks.thresholds.defaults.require_status;
  const bool by_default = defaults && &demand == &*defaults;
  Tally tally(gate_case, "status", demand.line);
  for (const Row* row : runs_for(gate_case, demand.runs, "status", demand.line, chosen.named, checks)) {
    const bool met =
        std::find(demand.expected.begin(), demand.expected.end(), row->status) != demand.expected.end();
    const std::string where = control_in_words(*row);
    if (met)
      tally.add(Outcome::pass, fmt::format("{} {}", row->status, where));
    else if (by_default && row->expected_order == 0)
      tally.add(Outcome::note, fmt::format("{} {}: {}", row->status, where, row->expected_because));
    else
      tally.add(of_unfinished(*row), fmt::format("{} {}, not {}{}", row->status, where,
                                                 fmt::join(demand.expected, " or "), because(*row)));
  }
  tally.finish(checks.findings);
}

std::string limit_in_words(const std::string& verdict, const std::optional<double>& limit) {
  return verdict == "limit" ? fmt::format("limit {:.10g} s", limit.value_or(absent)) : verdict;
}

void check_stability(const GateCase& gate_case, const Chosen<StabilityDemand>& chosen,
                     const CaseChecks& checks) {
  const StabilityDemand& demand = *chosen.demand;
  remember(gate_case, "stability", demand.line, chosen.named, !gate_case.stability.empty(), "stability row",
           checks);
  Tally tally(gate_case, "stability", demand.line);
  for (const StabilityRow* row : gate_case.stability) {
    const std::string measured = limit_in_words(row->verdict, row->measured);
    const std::string theory = limit_in_words(row->theory_verdict, row->theory);
    switch (judge_stability(*row, demand.relative)) {
      case StabilityMatch::agrees:
        tally.add(Outcome::pass, fmt::format("{}, theory {}", measured, theory));
        break;
      case StabilityMatch::differs:
        tally.add(Outcome::fail,
                  row->failure.empty()
                      ? fmt::format("{}, theory {}; they may differ by {:g} of it and {:.2g} s", measured,
                                    theory, demand.relative, row->resolution)
                      : row->failure);
        break;
      case StabilityMatch::nothing_to_compare:
        tally.add(Outcome::skipped, row->verdict == "blank"      ? row->reason
                                    : row->theory_reason.empty() ? "no theory is given"
                                                                 : row->theory_reason);
        break;
    }
  }
  tally.finish(checks.findings);
}

void check_stability_verdict(const GateCase& gate_case, const Chosen<StabilityVerdictDemand>& chosen,
                             const CaseChecks& checks) {
  const StabilityVerdictDemand& demand = *chosen.demand;
  remember(gate_case, "stability_verdict", demand.line, chosen.named, !gate_case.stability.empty(),
           "stability row", checks);
  Tally tally(gate_case, "stability_verdict", demand.line);
  for (const StabilityRow* row : gate_case.stability) {
    const bool met = row->verdict == demand.verdict;
    tally.add(
        met ? Outcome::pass : Outcome::fail,
        met ? row->verdict
            : fmt::format("{}{}, not {}", row->verdict,
                          row->measured ? fmt::format(" {:.6g} s", *row->measured) : "", demand.verdict));
  }
  tally.finish(checks.findings);
}

}  // namespace

Outcome of_unfinished(const Row& row) {
  if (row.status == "time_limit") return Outcome::missing;
  return row.provider != "odemark" && row.status == "solver_failed" ? Outcome::no_reference : Outcome::fail;
}

std::string control_in_words(const Row& row) {
  if (row.dt) return fmt::format("at dt {:.4g}", *row.dt);
  return row.rtol ? fmt::format("at rtol {:.4g}", *row.rtol) : row.id;
}

Tally::Tally(const GateCase& gate_case, std::string metric, int line) {
  finding_.case_name = gate_case.name;
  finding_.problem = gate_case.id.problem;
  finding_.method = gate_case.name.substr(std::min(gate_case.name.size(), gate_case.id.problem.size() + 1));
  finding_.metric = std::move(metric), finding_.line = line;
}

void Tally::add(Outcome outcome, std::string message) {
  if (any_ && outcome == finding_.outcome) ++finding_.others;
  if (any_ && outcome <= finding_.outcome) return;
  any_ = true;
  finding_.outcome = outcome, finding_.message = std::move(message), finding_.others = 0;
}

void Tally::finish(std::vector<Finding>& findings) const {
  if (any_) findings.push_back(finding_);
}

void check_demands(const GateCase& gate_case, const Demands& demands, const CaseChecks& checks) {
  if (demands.status && !demands.status.demand->off && !gate_case.executed.empty())
    check_status(gate_case, demands.status, checks);
  if (demands.order && !demands.order.demand->off && !gate_case.executed.empty())
    check_order(gate_case, demands.order, checks);
  if (demands.error && !gate_case.executed.empty()) check_error(gate_case, demands.error, checks);
  if (demands.drift && !gate_case.executed.empty()) check_drift(gate_case, demands.drift, checks);
  if (demands.stability && !demands.stability.demand->off)
    check_stability(gate_case, demands.stability, checks);
  if (demands.stability_verdict && !demands.stability_verdict.demand->off)
    check_stability_verdict(gate_case, demands.stability_verdict, checks);
}

}  // namespace odemark
