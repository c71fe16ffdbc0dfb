// Reading thresholds.toml: every key is known, has its type and its range, or the reader says which line is
// wrong.
#include "reports/thresholds.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <map>

#include "reports/check_toml.hpp"

namespace odemark {
namespace {

struct Reader : TomlReader {
  OrderDemand order(const toml::node& node) const {
    OrderDemand demand;
    demand.line = line_of(node);
    if (is_off(node)) {
      demand.off = true;
    } else if (node.is_string()) {
      one_of(node, "order", {"claimed", "off"});
      demand.claimed = true;
    } else {
      for (const auto& [key, value] : table(node, "order", "\"claimed\", \"off\" or { min = 3.8 }")) {
        if (key == "min")
          demand.min = number(value, "min");
        else if (key == "max")
          demand.max = number(value, "max");
        else if (key == "inconclusive")
          demand.inconclusive_fails = one_of(value, "inconclusive", {"fail", "note"}) == "fail";
        else
          unknown(key, "order", "min, max, inconclusive");
      }
      demand.claimed = !demand.min && !demand.max;
      if (demand.min && demand.max && *demand.min > *demand.max)
        refuse(demand.line, fmt::format("no order is above {} and below {}", *demand.min, *demand.max));
    }
    return demand;
  }

  ErrorDemand error(const toml::node& node) const {
    ErrorDemand demand;
    demand.line = line_of(node);
    bool chosen = false;
    const auto& t = table(node, "error", "{ at_dt = 0.1, max = 1e-6 }, a list of such or \"off\"");
    for (const auto& [key, value] : t) {
      if (selects(demand.runs, chosen, key, value)) continue;
      if (key == "max")
        demand.max = positive(value, "max");
      else if (key == "norm")
        demand.norm = one_of(value, "norm",
                             {"scaled", "absolute", "relative", "rms", "trajectory_max", "trajectory_rms",
                              "amplitude", "phase"});
      else
        unknown(key, "error", "max, norm, at_dt, up_to_dt, from_dt, at_steps, at_tol, at");
    }
    needed(t, "max", "error");
    if (!chosen) refuse(demand.line, "error needs at_dt, at_steps, at_tol or at = \"finest\"");
    return demand;
  }

  DriftDemand drift(const toml::node& node) const {
    DriftDemand demand;
    demand.line = line_of(node);
    bool chosen = false;
    const auto& t = table(node, "drift", "{ invariant = \"energy\", max = 1e-3 }, a list of such or \"off\"");
    for (const auto& [key, value] : t) {
      if (selects(demand.runs, chosen, key, value)) continue;
      if (key == "max")
        demand.max = positive(value, "max");
      else if (key == "invariant")
        demand.invariant = text(value, "invariant");
      else
        unknown(key, "drift", "invariant, max, at_dt, up_to_dt, from_dt, at_steps, at_tol, at");
    }
    needed(t, "max", "drift"), needed(t, "invariant", "drift");
    return demand;
  }

  StatusDemand status(const toml::node& node) const {
    StatusDemand demand;
    demand.line = line_of(node);
    if (is_off(node)) {
      demand.off = true;
      return demand;
    }
    const toml::node* expected = &node;
    if (node.is_table()) {
      bool chosen = false;
      for (const auto& [key, value] : *node.as_table())
        if (!selects(demand.runs, chosen, key, value) && key != "is")
          unknown(key, "status", "is, at_dt, up_to_dt, from_dt, at_steps, at_tol, at");
      expected = &needed(*node.as_table(), "is", "status");
    }
    demand.expected = texts(*expected, "status");
    for (const auto& s : demand.expected) {
      static constexpr std::array<std::string_view, 8> known{
          "reached_end",     "step_limit", "step_underflow", "not_finite",
          "newton_diverged", "time_limit", "rhs_failed",     "solver_failed"};
      if (std::find(known.begin(), known.end(), s) == known.end())
        refuse(demand.line, fmt::format("there is no status \"{}\": {}", s, fmt::join(known, ", ")));
    }
    return demand;
  }

  template <class Demand, class One>
  std::vector<Demand> list(const toml::node& node, One one) const {
    std::vector<Demand> all;
    if (is_off(node)) return all;
    if (!node.is_array()) return {one(node)};
    for (const auto& element : *node.as_array()) all.push_back(one(element));
    if (all.empty()) refuse(line_of(node), "an empty list demands nothing: write \"off\"");
    return all;
  }

  FactorDemand evaluations(const toml::node& node) const {
    const auto& t = table(node, "evaluations", "{ max_factor = 1.1 }");
    for (const auto& [key, value] : t)
      if (key != "max_factor") unknown(key, "evaluations", "max_factor");
    return {line_of(node), factor(needed(t, "max_factor", "evaluations"), "max_factor")};
  }

  StabilityDemand stability(const toml::node& node) const {
    if (is_off(node)) return {line_of(node), true};
    const auto& t = table(node, "stability", "{ rel = 1e-6 } or \"off\"");
    for (const auto& [key, value] : t)
      if (key != "rel") unknown(key, "stability", "rel");
    return {line_of(node), false, positive(needed(t, "rel", "stability"), "rel")};
  }

  Rule rule(const toml::node& node) const;
  Defaults defaults(const toml::node& node) const;
};

Rule Reader::rule(const toml::node& node) const {
  Rule rule;
  rule.line = line_of(node);
  for (const auto& [key, value] : table(node, "a rule", "as a table: [[rule]]")) {
    const int line = line_of(value);
    if (key == "case")
      rule.cases = texts(value, "case");
    else if (key == "provider")
      rule.provider = text(value, "provider");
    else if (key == "scalar")
      rule.scalar = text(value, "scalar");
    else if (key == "compensated")
      rule.compensated = flag(value, "compensated");
    else if (key == "optional")
      rule.optional = flag(value, "optional");
    else if (key == "skip")
      rule.skip = flag(value, "skip");
    else if (key == "reason")
      rule.reason = text(value, "reason");
    else if (key == "until")
      rule.until = date(value, "until");
    else if (key == "order")
      rule.order = order(value);
    else if (key == "error")
      rule.error = list<ErrorDemand>(value, [&](const auto& v) { return error(v); });
    else if (key == "drift")
      rule.drift = list<DriftDemand>(value, [&](const auto& v) { return drift(v); });
    else if (key == "status")
      rule.status = status(value);
    else if (key == "evaluations")
      rule.evaluations = evaluations(value);
    else if (key == "baseline_factor")
      rule.baseline = FactorDemand{line, factor(value, "baseline_factor")};
    else if (key == "stability")
      rule.stability = stability(value);
    else if (key == "stability_verdict")
      rule.stability_verdict = StabilityVerdictDemand{
          line, is_off(value), one_of(value, "stability_verdict", {"limit", "unstable", "unlimited", "off"})};
    else
      unknown(
          key, "a rule",
          "case, provider, scalar, compensated, optional, skip, reason, until, order, error, drift, status, "
          "evaluations, baseline_factor, stability, stability_verdict");
  }
  if (rule.cases.empty()) refuse(rule.line, "a rule needs case = \"problem/method\"");
  for (const auto& glob : rule.cases)
    if (glob.find('/') == glob.npos && glob != "*")
      refuse(rule.line, fmt::format("case = \"{}\" has no \"/\": write \"problem/method\"", glob));
  const bool demands = rule.order || rule.error || rule.drift || rule.status || rule.evaluations ||
                       rule.baseline || rule.stability || rule.stability_verdict;
  if (rule.skip.value_or(false)) {
    if (rule.reason.empty()) refuse(rule.line, "skip = true needs a reason");
    if (demands) refuse(rule.line, "a rule that skips cannot demand anything too");
  } else if (!rule.until.empty()) {
    refuse(rule.line, "until belongs to skip = true");
  } else if (!demands && !rule.skip) {
    refuse(rule.line, "the rule demands nothing");
  }
  return rule;
}

Defaults Reader::defaults(const toml::node& node) const {
  Defaults defaults;
  for (const auto& [key, value] : table(node, "defaults", "as a table: [defaults]")) {
    if (key == "baseline_factor")
      defaults.baseline_factor = factor(value, "baseline_factor"), defaults.needs_baseline = true;
    else if (key == "evaluations_factor")
      defaults.evaluations_factor = factor(value, "evaluations_factor"), defaults.needs_baseline = true;
    else if (key == "floor")
      defaults.floor = positive(value, "floor");
    else if (key == "order_slack")
      defaults.order_slack = positive(value, "order_slack");
    else if (key == "require_status")
      defaults.require_status = status(value);
    else
      unknown(key, "[defaults]", "baseline_factor, evaluations_factor, floor, order_slack, require_status");
  }
  return defaults;
}

}  // namespace

Thresholds parse_thresholds(std::string_view toml_text, std::string_view name) {
  const Reader reader{{std::string(name)}};
  Thresholds thresholds;
  thresholds.name = name;
  toml::table file;
  try {
    file = toml::parse(toml_text, name);
  } catch (const toml::parse_error& e) {
    reader.refuse(static_cast<int>(e.source().begin.line), std::string(e.description()));
  }
  for (const auto& [key, value] : file) {
    if (key == "schema") {
      if (value.value<std::int64_t>() != std::int64_t{thresholds_schema})
        reader.refuse(line_of(value), fmt::format("this odemark reads schema = {}", thresholds_schema));
    } else if (key == "defaults") {
      thresholds.defaults = reader.defaults(value);
    } else if (key == "rule") {
      if (!value.is_array()) reader.refuse(line_of(value), "rules are written [[rule]], with two brackets");
      for (const auto& rule : *value.as_array()) thresholds.rules.push_back(reader.rule(rule));
    } else {
      reader.unknown(key, "the file", "schema, [defaults], [[rule]]");
    }
  }
  if (!file.contains("schema"))
    reader.refuse(1, fmt::format("the file must say schema = {}", thresholds_schema));
  for (const auto& rule : thresholds.rules)
    if (rule.evaluations || rule.baseline) thresholds.defaults.needs_baseline = true;
  return thresholds;
}

}  // namespace odemark
