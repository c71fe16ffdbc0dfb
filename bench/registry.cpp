#include "bench/registry.hpp"

#include <fmt/format.h>

#include <set>

#include "reference/bad_input.hpp"
#include "reference/contestants.hpp"

namespace odemark {

namespace {

std::vector<std::string_view> split(std::string_view text) {
  std::vector<std::string_view> parts;
  while (!text.empty()) {
    const std::size_t comma = std::min(text.find(','), text.size());
    if (comma > 0) parts.push_back(text.substr(0, comma));
    text.remove_prefix(std::min(comma + 1, text.size()));
  }
  return parts;
}

}  // namespace

bool matches(std::string_view pattern, std::string_view text) {
  if (pattern.empty()) return text.empty();
  if (pattern.front() == '*')
    return matches(pattern.substr(1), text) || (!text.empty() && matches(pattern, text.substr(1)));
  return !text.empty() && (pattern.front() == '?' || pattern.front() == text.front()) &&
         matches(pattern.substr(1), text.substr(1));
}

Registry suite_registry() {
  Registry registry{suite_methods(), suite_families()};
  for (auto& contestant : contestants()) registry.methods.push_back(std::move(contestant));
  return registry;
}

void require_unique_names(const Registry& registry) {
  std::set<std::string, std::less<>> ids;
  for (const auto& method : registry.methods)
    if (!ids.emplace(method.id).second)
      throw BadInput(
          fmt::format("two methods are called {}: the suite has one, call yours otherwise", method.id));
  ids.clear();
  for (const auto& id : problem_ids(registry.families))
    if (!ids.emplace(id).second)
      throw BadInput(fmt::format("two problems are called {}: the suite has one, call yours otherwise", id));
}

const AnyMethod& find_method(const Registry& registry, std::string_view id) {
  std::vector<std::string> ids;
  for (const auto& method : registry.methods) {
    if (method.id == id) return method;
    ids.emplace_back(method.id);
  }
  throw BadInput(fmt::format("there is no method \"{}\"{}: `odemark list --methods` shows them all", id,
                             suggestion(id, ids)));
}

std::vector<const AnyMethod*> select_methods(const Registry& registry, std::string_view patterns) {
  std::vector<const AnyMethod*> chosen;
  const auto all = split(patterns);
  for (const auto pattern : all) {
    bool found = false;
    for (const auto& method : registry.methods) found = found || matches(pattern, method.id);
    if (!found) find_method(registry, pattern);
  }
  for (const auto& method : registry.methods) {
    bool wanted = all.empty();
    for (const auto pattern : all) wanted = wanted || matches(pattern, method.id);
    if (wanted) chosen.push_back(&method);
  }
  return chosen;
}

std::vector<AnyProblem> select_problems(const Registry& registry, std::string_view patterns,
                                        std::string_view settings) {
  std::vector<AnyProblem> chosen;
  const auto all = split(patterns);
  if (all.empty()) {
    for (const auto& id : problem_ids(registry.families))
      chosen.push_back(find_problem(registry.families, id, settings));
    return chosen;
  }
  for (const auto pattern : all) {
    bool found = false;
    for (const auto& id : problem_ids(registry.families))
      if (pattern != id && pattern.find_first_of("*?") != pattern.npos && matches(pattern, id)) {
        chosen.push_back(find_problem(registry.families, id, settings));
        found = true;
      }
    if (!found) chosen.push_back(find_problem(registry.families, pattern, settings));
  }
  return chosen;
}

}  // namespace odemark
