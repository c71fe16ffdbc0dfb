// From settings in text to a family value, in double or wide arithmetic, with every check a user deserves.
#pragma once

#include <string>
#include <vector>

#include "problems/family.hpp"
#include "reference/bad_input.hpp"
#include "reference/settings.hpp"

namespace odemark {

/// Throws BadInput if the value lies outside the range of the parameter `name` of `family`.
void check_range(std::string_view family, std::string_view name, std::string_view unit,
                 const Setting& setting, const Range& range);
/// Throws BadInput if a setting has a name that is not known, with the nearest one that is.
void check_names(std::string_view family, const std::vector<std::string>& known,
                 const std::vector<Setting>& settings);
[[noreturn]] void contradiction(std::string_view family, const Setting& setting);

/// The family value for a preset with a user's settings on top. `read(name, text)` turns a value's text into
/// Real. A preset's shorthands see the user's parameters (zeta = 1 stays critical for the user's k) and yield
/// to them where both set the same thing.
template <class Family, class Real, class Read>
Family configure(const std::vector<Setting>& preset, const std::vector<Setting>& user, Read&& read) {
  Family family;
  std::vector<std::string> known;
  const auto parameters = Family::parameters();
  for (const auto& p : parameters) known.emplace_back(p.name);
  if constexpr (requires { Family::shorthands(); })
    for (const auto& s : Family::shorthands()) known.emplace_back(s.name);
  check_names(Family::id, known, preset);
  check_names(Family::id, known, user);
  const auto checked = [&](const auto& described, const Setting& setting) -> Real {
    check_range(Family::id, described.name, described.unit, setting, described.range);
    return read(setting.name, setting.value);
  };
  const auto set_parameters = [&](const std::vector<Setting>& settings) {
    for (const auto& setting : settings)
      for (const auto& p : parameters)
        if (p.name == setting.name) family.*p.member = checked(p, setting);
  };
  const auto apply_shorthands = [&](const std::vector<Setting>& settings) {
    if constexpr (requires { Family::shorthands(); })
      for (const auto& s : Family::shorthands())
        for (const auto& setting : settings)
          if (s.name == setting.name) s.apply(family, checked(s, setting));
  };
  set_parameters(preset);
  set_parameters(user);
  apply_shorthands(preset);
  set_parameters(user);
  const Family before = family;
  apply_shorthands(user);
  for (const auto& setting : user)
    for (const auto& p : parameters)
      if (p.name == setting.name && family.*p.member != before.*p.member) contradiction(Family::id, setting);
  if constexpr (requires { family.validate(); })
    if (const std::string fault = family.validate(); !fault.empty()) throw BadInput(fault);
  return family;
}

}  // namespace odemark
