// odemark methods: what is known of a method from its coefficients, and measured.
#include <fmt/format.h>

#include <cmath>

#include "bench/cli/commands.hpp"
#include "bench/cli/progress.hpp"
#include "bench/facts.hpp"
#include "bench/measured_facts.hpp"
#include "reports/method_page.hpp"
#include "reports/table.hpp"

namespace odemark {

namespace {

std::vector<const AnyMethod*> chosen(const Registry& registry, const std::vector<std::string>& names) {
  std::vector<const AnyMethod*> out;
  if (names.empty()) {
    for (const auto& method : registry.methods)
      if (method.provider == "odemark") out.push_back(&method);
    return out;
  }
  for (const auto& name : names)
    for (const auto* method : select_methods(registry, name)) out.push_back(method);
  return out;
}

}  // namespace

int methods_command(const Registry& registry, const MethodsCommandOptions& options) {
  std::vector<FactSheet> sheets;
  std::vector<std::string> faults;
  {
    Progress progress("facts of methods", options);
    const auto methods = chosen(registry, options.names);
    for (std::size_t i = 0; i < methods.size(); ++i) {
      sheets.push_back(fact_sheet(*methods[i]));
      for (auto& fault : claim_faults(*methods[i])) faults.push_back(std::move(fault));
      if (options.measured) {
        sheets.back().measured = measure_facts(*methods[i]);
        for (auto& fault : measured_faults(sheets.back())) faults.push_back(std::move(fault));
      }
      progress.update(i + 1, methods.size(), std::string(methods[i]->id));
    }
  }
  if (options.format == "json") {
    fmt::print("[\n");
    for (std::size_t i = 0; i < sheets.size(); ++i)
      fmt::print("{}{}\n", to_json(sheets[i]), i + 1 < sheets.size() ? "," : "");
    fmt::print("]\n");
  } else if (sheets.size() == 1) {
    fmt::print("{}\n", to_text(facts_table(sheets[0])));
    if (options.measured) fmt::print("{}\n", to_text(measured_table(sheets[0])));
  } else {
    fmt::print("{}\n", to_text(overview_table(sheets)));
    if (options.measured)
      for (const auto& sheet : sheets) fmt::print("{}\n", to_text(measured_table(sheet)));
  }
  for (const auto& fault : faults) fmt::print(stderr, "odemark: {}\n", fault);
  return faults.empty() ? exit_ok : exit_violated;
}

}  // namespace odemark
