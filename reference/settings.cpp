#include "reference/settings.hpp"

#include <charconv>
#include <cmath>

#include "reference/bad_input.hpp"

namespace odemark {

namespace {

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
  while (!text.empty() && (text.back() == ' ' || text.back() == '\t')) text.remove_suffix(1);
  return text;
}

bool read_decimal(std::string_view text, double& value) {
  if (!text.empty() && text.front() == '+') text.remove_prefix(1);
  const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
  return result.ec == std::errc{} && result.ptr == text.data() + text.size() && std::isfinite(value);
}

}  // namespace

std::vector<Setting> parse_settings(std::string_view text) {
  std::vector<Setting> settings;
  if (trimmed(text).empty()) return settings;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const std::string_view part = trimmed(text.substr(begin, end - begin));
    const std::size_t equals = part.find('=');
    const auto name = trimmed(part.substr(0, std::min(equals, part.size())));
    if (equals == part.npos || name.empty() || trimmed(part.substr(equals + 1)).empty())
      throw BadInput("\"" + std::string(part) +
                     "\" is not a setting: write name=value, several with commas, like k=6e5,m=168");
    for (const auto& earlier : settings)
      if (earlier.name == name) throw BadInput("\"" + std::string(name) + "\" is set twice: give it once");
    settings.push_back({std::string(name), std::string(trimmed(part.substr(equals + 1)))});
    begin = end + 1;
  }
  return settings;
}

double parse_number(std::string_view name, std::string_view text) {
  double top = 0, bottom = 1;
  const std::size_t slash = text.find('/');
  const bool good = slash == text.npos ? read_decimal(text, top)
                                       : read_decimal(text.substr(0, slash), top) &&
                                             read_decimal(text.substr(slash + 1), bottom) && bottom != 0;
  if (!good || !std::isfinite(top / bottom))
    throw BadInput("\"" + std::string(text) + "\" is no value for " + std::string(name) +
                   ": write a finite number like 0.1, -3e5 or 8/3");
  return top / bottom;
}

std::string to_string(const std::vector<Setting>& settings) {
  std::string text;
  for (const auto& s : settings) text += (text.empty() ? "" : ",") + s.name + "=" + s.value;
  return text;
}

}  // namespace odemark
