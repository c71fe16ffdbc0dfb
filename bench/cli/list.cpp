// odemark list: what there is to run.
#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "bench/cli/commands.hpp"
#include "bench/problem_sheets.hpp"
#include "reference/truth.hpp"
#include "reports/table.hpp"

namespace odemark {

namespace {

std::string needs_text(unsigned needs) {
  return std::string(missing_ability(needs, Ability::jacobian | Ability::recordable));
}

nlohmann::ordered_json methods_json(const Registry& registry) {
  auto all = nlohmann::ordered_json::array();
  for (const auto& m : registry.methods)
    all.push_back({{"id", m.id},
                   {"kind", m.kind},
                   {"provider", m.provider},
                   {"order", m.order},
                   {"embedded_order", m.embedded_order},
                   {"fixed_steps", m.takes_fixed_steps},
                   {"error_control", m.takes_error_control},
                   {"compensated", m.compensated},
                   {"starter", m.starter},
                   {"needs", needs_text(m.needs)},
                   {"note", m.note},
                   {"source", m.source}});
  return all;
}

/// Null where none is stored: `odemark truth` computes it.
nlohmann::ordered_json truth_json(const AnyProblem& problem) {
  const auto truth = stored_truth_of(problem);
  if (!truth) return nullptr;
  return {{"digits", truth->digits},
          {"origin", truth->origin},
          {"checked_by", truth->checked_by},
          {"events", truth->events.size()}};
}

nlohmann::ordered_json problems_json(const Registry& registry) {
  auto all = nlohmann::ordered_json::array();
  for (const auto& f : registry.families)
    for (const auto& preset : f.presets) {
      const AnyProblem problem = f.create(preset, {});
      auto parameters = nlohmann::ordered_json::array();
      for (const auto& p : f.parameters) {
        nlohmann::ordered_json j{
            {"name", p.name}, {"unit", p.unit}, {"meaning", p.meaning}, {"range", range_text(p.range)}};
        if (p.shorthand)
          j["shorthand"] = true;
        else
          for (const auto& value : problem.parameters)
            if (value.name == p.name) j["value"] = value.value;
        parameters.push_back(j);
      }
      auto components = nlohmann::ordered_json::array();
      for (const auto& c : f.components) components.push_back({{"name", c.name}, {"unit", c.unit}});
      all.push_back({{"id", preset.id},
                     {"family", f.id},
                     {"title", f.title},
                     {"equations", f.equations},
                     {"about", preset.about},
                     {"t_end", problem.t_end},
                     {"suggested_dt", problem.suggested_dt},
                     {"components", components},
                     {"parameters", parameters},
                     {"invariants", f.invariant_names},
                     {"events", f.event_names},
                     {"switch_times", problem.switch_times},
                     {"closed_form", f.has_exact},
                     {"truth", truth_json(problem)},
                     {"source", f.source}});
    }
  return all;
}

Table methods_table(const Registry& registry) {
  Table table;
  table.title = "Methods (notes and sources: --format json)";
  for (const char* name : {"method", "kind", "order", "control", "needs"}) table.columns.push_back({name});
  for (const auto& m : registry.methods) {
    const std::string order =
        m.embedded_order > 0 ? fmt::format("{}({})", m.order, m.embedded_order) : fmt::format("{}", m.order);
    const std::string control = m.takes_fixed_steps && m.takes_error_control ? "dt, tol"
                                : m.takes_fixed_steps                        ? "dt"
                                                                             : "tol";
    table.rows.push_back(
        {{std::string(m.id)}, {std::string(m.kind)}, {order}, {control}, {needs_text(m.needs)}});
  }
  return table;
}

Table problems_table(const Registry& registry) {
  Table table;
  std::size_t presets = 0, stored = 0, thirty = 0, closed = 0;
  for (const char* name : {"problem", "about", "t_end", "dt", "truth", "digits", "parameters for --set"})
    table.columns.push_back({name});
  for (const auto& f : registry.families)
    for (const auto& preset : f.presets) {
      const AnyProblem problem = f.create(preset, {});
      std::string parameters;
      for (const auto& p : problem.parameters)
        parameters += fmt::format("{}{}={:g}", parameters.empty() ? "" : ",", p.name, p.value);
      for (const auto& p : f.parameters)
        if (p.shorthand) parameters += fmt::format(",[{}]", p.name);
      const auto truth = stored_truth_of(problem);
      ++presets, stored += truth != nullptr, thirty += truth && truth->digits >= 30, closed += f.has_exact;
      table.rows.push_back({{std::string(preset.id)},
                            {std::string(preset.about)},
                            {fmt::format("{:g}", problem.t_end)},
                            {fmt::format("{:g}", problem.suggested_dt)},
                            {f.has_exact ? "closed form" : "two computations"},
                            {truth ? fmt::format("{}", truth->digits) : "-"},
                            {parameters}});
    }
  table.title = fmt::format(
      "Problems: {} families, {} presets; {} have a closed form, {} a stored solution, {} of these with 30 "
      "digits or more",
      registry.families.size(), presets, closed, stored, thirty);
  return table;
}

}  // namespace

int list_command(const Registry& registry, const ListOptions& options) {
  const bool all = !options.methods && !options.problems && !options.suites;
  if (options.format == "json") {
    nlohmann::ordered_json j;
    if (all || options.methods) j["methods"] = methods_json(registry);
    if (all || options.problems) j["problems"] = problems_json(registry);
    if (all || options.suites) j["suites"] = suite_names();
    fmt::print("{}\n", j.dump(2));
    return exit_ok;
  }
  if (options.format == "names") {
    if (all || options.methods)
      for (const auto& m : registry.methods) fmt::print("{}\n", m.id);
    if (all || options.problems)
      for (const auto& id : problem_ids(registry.families)) fmt::print("{}\n", id);
    if (all || options.suites)
      for (const auto& name : suite_names()) fmt::print("{}\n", name);
    return exit_ok;
  }
  if (all || options.methods) fmt::print("{}\n", to_text(methods_table(registry)));
  if (all || options.problems) fmt::print("{}\n", to_text(problems_table(registry)));
  if (all || options.suites) fmt::print("Suites: {}\n", fmt::join(suite_names(), ", "));
  return exit_ok;
}

}  // namespace odemark
