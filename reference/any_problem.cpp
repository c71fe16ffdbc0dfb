#include "reference/any_problem.hpp"

#include "reference/bad_input.hpp"

namespace odemark {

std::vector<std::string> problem_ids(const std::vector<AnyFamily>& families) {
  std::vector<std::string> ids;
  for (const auto& family : families)
    for (const auto& preset : family.presets) ids.emplace_back(preset.id);
  return ids;
}

void name_problem(AnyProblem& problem, const Preset& preset, const std::vector<Setting>& user) {
  problem.preset = std::string(preset.id);
  problem.customised = !user.empty();
  problem.id = problem.preset + (user.empty() ? "" : "{" + to_string(user) + "}");
  problem.preset_settings = std::string(preset.settings);
  problem.user_settings = to_string(user);
  problem.about = preset.about;
}

AnyProblem find_problem(const std::vector<AnyFamily>& families, std::string_view id,
                        std::string_view settings) {
  const auto user = parse_settings(settings);
  for (const auto& family : families)
    for (const auto& preset : family.presets)
      if (preset.id == id) return family.create(preset, user);
  for (const auto& family : families)  // a family's name stands for its first preset
    if (family.id == id) return family.create(family.presets.front(), user);
  auto candidates = problem_ids(families);
  for (const auto& family : families) candidates.emplace_back(family.id);
  throw BadInput("there is no problem \"" + std::string(id) + "\"" + suggestion(id, candidates) +
                 ": `odemark list --problems` shows them all");
}

}  // namespace odemark
