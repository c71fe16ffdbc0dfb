// "k=6e5,m=168,zeta=0.1": what a user or a preset sets, as text, so that it can be read in any precision.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace odemark {

struct Setting {
  std::string name, value;
};

/// Splits at commas and the first '=' of each part; throws BadInput for anything else. Empty text: no
/// settings.
std::vector<Setting> parse_settings(std::string_view text);

/// A decimal number ("0.1", "-3e5") or a quotient of two ("8/3"), finite; throws BadInput naming `name`
/// otherwise.
double parse_number(std::string_view name, std::string_view text);

/// Back to text, in the order given.
std::string to_string(const std::vector<Setting>& settings);

}  // namespace odemark
