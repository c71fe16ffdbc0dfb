#include "reference/configure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace odemark {

void check_range(std::string_view family, std::string_view name, std::string_view unit,
                 const Setting& setting, const Range& range) {
  const double value = parse_number(setting.name, setting.value);
  const bool low = range.open_below ? value > range.lowest : value >= range.lowest;
  const bool high = range.open_above ? value < range.highest : value <= range.highest;
  const bool counts = !range.whole || value == std::floor(value);
  if (low && high && counts) return;
  std::string wanted;
  if (range.lowest > -std::numeric_limits<double>::infinity())
    wanted += fmt::format("{} {:g}", range.open_below ? "above" : "at least", range.lowest);
  if (range.highest < std::numeric_limits<double>::infinity())
    wanted += fmt::format("{}{} {:g}", wanted.empty() ? "" : " and ", range.open_above ? "below" : "at most",
                          range.highest);
  throw BadInput(fmt::format("{}={} is out of range for {}: it must be {}{}{}{}", name, setting.value, family,
                             range.whole ? "a whole number " : "", wanted, unit.empty() ? "" : " ", unit));
}

void check_names(std::string_view family, const std::vector<std::string>& known,
                 const std::vector<Setting>& settings) {
  for (const auto& setting : settings)
    if (std::find(known.begin(), known.end(), setting.name) == known.end())
      throw BadInput(fmt::format("{} has no parameter \"{}\"{}: it has {}", family, setting.name,
                                 suggestion(setting.name, known), fmt::join(known, ", ")));
}

void contradiction(std::string_view family, const Setting& setting) {
  throw BadInput(fmt::format("{}={} contradicts another setting of {} that also sets {}: give one of the two",
                             setting.name, setting.value, family, setting.name));
}

}  // namespace odemark
