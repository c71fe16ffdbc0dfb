// Rules onto cases, selectors onto runs, and rules that mean nothing that was run.
#include "reports/check_rules.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "reports/numbers.hpp"

namespace odemark {
namespace {

std::string plain_name(const GateCase& gate_case) { return gate_case.id.problem + "/" + gate_case.id.method; }

enum class Match { none, by_glob, by_name };

Match match_of(const Rule& rule, const GateCase& gate_case) {
  if (!matches_glob(rule.provider, gate_case.provider) || !matches_glob(rule.scalar, gate_case.id.scalar) ||
      rule.compensated != gate_case.id.compensated)
    return Match::none;
  Match best = Match::none;
  for (const auto& glob : rule.cases)
    if (matches_glob(glob, plain_name(gate_case)))
      best = std::max(best, is_glob(glob) ? Match::by_glob : Match::by_name);
  return best;
}

template <class T>
void override_with(Chosen<T>& chosen, const std::optional<T>& demand, Match match) {
  if (demand) chosen = {&*demand, match == Match::by_name};
}

/// Number of single-letter edits from one text to the other.
std::size_t distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0]++;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t changed = diagonal + (a[i] != b[j]);
      diagonal = row[j + 1];
      row[j + 1] = std::min({changed, row[j] + 1, row[j + 1] + 1});
    }
  }
  return row.back();
}

[[noreturn]] void refuse_name(const Thresholds& thresholds, const Rule& rule, const std::string& name,
                              const std::vector<GateCase>& cases) {
  std::string hint;
  std::size_t nearest = 1 + name.size() / 4;
  for (const GateCase& c : cases) {
    if (plain_name(c) == name) {
      if (!c.was_run())
        hint = fmt::format(": {}", c.blank.empty() ? "it did not run" : c.blank.front()->reason);
      else if (c.provider != "odemark" && !matches_glob(rule.provider, c.provider))
        hint = fmt::format(": it belongs to {}, add provider = \"{}\" to the rule", c.provider, c.provider);
      else
        hint = fmt::format(": it ran as {}, not in the rule's scalar or compensation", c.name);
      break;
    }
    const std::size_t d = c.was_run() ? distance(name, plain_name(c)) : name.size();
    if (d < nearest) nearest = d, hint = fmt::format(": is it \"{}\"?", plain_name(c));
  }
  throw BadThresholds(
      fmt::format("{}:{}: no executed case is \"{}\"{}", thresholds.name, rule.line, name, hint));
}

}  // namespace

bool GateCase::was_run() const {
  return !executed.empty() || std::any_of(stability.begin(), stability.end(),
                                          [](const StabilityRow* row) { return row->verdict != "blank"; });
}

GateCase blank_case(const CurveId& id, const std::string& provider) {
  GateCase c;
  c.id = id, c.name = case_name(id), c.provider = provider.empty() ? "odemark" : provider;
  return c;
}

CurveId parse_case_name(std::string_view name) {
  CurveId id;
  id.scalar = "double";
  if (const std::size_t bracket = name.rfind(" ["); bracket != name.npos && name.ends_with(']')) {
    std::string_view inside = name.substr(bracket + 2, name.size() - bracket - 3);
    const std::size_t comma = inside.find(", compensated");
    id.compensated = comma != inside.npos;
    id.scalar = inside.substr(0, comma);
    name = name.substr(0, bracket);
  }
  const std::size_t slash = std::min(name.rfind('/'), name.size());
  id.problem = name.substr(0, slash);
  id.method = slash < name.size() ? name.substr(slash + 1) : std::string_view();
  return id;
}

bool matches(const Rule& rule, const GateCase& gate_case) { return match_of(rule, gate_case) != Match::none; }

Demands demands_on(const GateCase& gate_case, const Thresholds& thresholds, const std::string& today) {
  Demands d;
  if (gate_case.provider == "odemark" && thresholds.defaults.require_status)
    d.status = {&*thresholds.defaults.require_status, false};
  for (const Rule& rule : thresholds.rules) {
    const Match match = match_of(rule, gate_case);
    if (match == Match::none) continue;
    override_with(d.order, rule.order, match);
    override_with(d.error, rule.error, match);
    override_with(d.drift, rule.drift, match);
    override_with(d.status, rule.status, match);
    override_with(d.stability, rule.stability, match);
    override_with(d.stability_verdict, rule.stability_verdict, match);
    override_with(d.evaluations, rule.evaluations, match);
    override_with(d.baseline, rule.baseline, match);
    const bool expired = !rule.until.empty() && !today.empty() && today > rule.until;
    if (rule.skip && !expired) {
      d.skipped = *rule.skip, d.skip_line = rule.line;
      d.skip_reason =
          rule.until.empty() ? rule.reason : fmt::format("{} (until {})", rule.reason, rule.until);
    }
  }
  return d;
}

std::vector<const Row*> select_runs(const GateCase& gate_case, const RunSelector& runs) {
  using Kind = RunSelector::Kind;
  constexpr double typed = 5e-3;  // people round the dt they type to three digits
  long most_steps = 0;
  double least_tolerance = infinity;
  for (const Row* row : gate_case.executed) {
    most_steps = std::max(most_steps, row->steps.value_or(0));
    least_tolerance = std::min(least_tolerance, row->rtol.value_or(infinity));
  }
  const auto chosen = [&](const Row& row) {
    const double dt = row.dt.value_or(std::nan("")), v = runs.value;
    switch (runs.kind) {
      case Kind::every: return true;
      case Kind::finest:
        return row.steps ? *row.steps == most_steps : row.rtol.value_or(infinity) <= least_tolerance;
      case Kind::at_dt: return std::abs(dt - v) <= typed * v;
      case Kind::up_to_dt: return dt <= v * (1 + typed);
      case Kind::from_dt: return dt >= v * (1 - typed);
      case Kind::at_steps: return row.steps && std::abs(static_cast<double>(*row.steps) - v) < 0.5;
      case Kind::at_tol: return row.rtol && std::abs(*row.rtol - v) <= typed * v;
    }
    return false;
  };
  std::vector<const Row*> found;
  for (const Row* row : gate_case.executed)
    if (chosen(*row)) found.push_back(row);
  return found;
}

std::string in_words(const RunSelector& runs) {
  using Kind = RunSelector::Kind;
  switch (runs.kind) {
    case Kind::every: return "at all";
    case Kind::finest: return "at the finest control";
    case Kind::at_dt: return fmt::format("at dt {:.4g}", runs.value);
    case Kind::up_to_dt: return fmt::format("up to dt {:.4g}", runs.value);
    case Kind::from_dt: return fmt::format("from dt {:.4g}", runs.value);
    case Kind::at_steps: return fmt::format("with {:.0f} steps", runs.value);
    case Kind::at_tol: return fmt::format("at rtol {:.4g}", runs.value);
  }
  return "";
}

std::vector<std::pair<std::string, int>> unmatched_globs(const Thresholds& thresholds,
                                                         const std::vector<GateCase>& cases) {
  std::vector<std::pair<std::string, int>> unmatched;
  for (const Rule& rule : thresholds.rules)
    for (const auto& glob : rule.cases) {
      Rule one = rule;
      one.cases = {glob};
      const bool hit = std::any_of(cases.begin(), cases.end(),
                                   [&](const GateCase& c) { return c.was_run() && matches(one, c); });
      if (hit) continue;
      if (!is_glob(glob)) refuse_name(thresholds, rule, glob, cases);
      unmatched.emplace_back(glob, rule.line);
    }
  return unmatched;
}

}  // namespace odemark
