#include "reference/any_problem.hpp"

#include "reference/bad_input.hpp"

namespace odemark {

ComponentNames numbered_components(std::span<const Component> groups, std::size_t size) {
  const std::size_t each = size / groups.size();
  std::string letters;
  std::vector<std::size_t> ends;
  for (const Component& group : groups)
    for (std::size_t i = 1; i <= each; ++i) {
      letters += group.name;
      letters += std::to_string(i);
      ends.push_back(letters.size());
    }
  ComponentNames names{std::make_shared<const std::string>(std::move(letters)), {}};
  const std::string_view text = *names.letters;
  for (std::size_t i = 0, begin = 0; i < ends.size(); begin = ends[i++])
    names.all.push_back({text.substr(begin, ends[i] - begin), groups[i / each].unit});
  return names;
}

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
