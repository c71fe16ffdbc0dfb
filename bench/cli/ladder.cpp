// A list with commas, or start, ratio and count with colons.
#include "bench/cli/ladder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "reference/bad_input.hpp"
#include "reference/settings.hpp"

namespace odemark {

std::vector<double> parse_ladder(std::string_view option, const std::string& text) {
  std::vector<double> values;
  std::vector<std::string> parts;
  const char separator = text.find(':') != text.npos ? ':' : ',';
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(separator, begin), text.size());
    parts.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  if (separator == ',') {
    for (const auto& part : parts) values.push_back(parse_number(option, part));
    return values;
  }
  if (parts.size() != 3)
    throw BadInput(
        fmt::format("{} {}: write start:ratio:count, like 0.1:0.5:10, or values with commas", option, text));
  double value = parse_number(option, parts[0]);
  const double ratio = parse_number(option, parts[1]), count = parse_number(option, parts[2]);
  if (!(ratio > 0) || ratio == 1 || !(count >= 1 && count <= 1000) || count != std::floor(count))
    throw BadInput(fmt::format(
        "{} {}: the ratio must be above 0 and not 1, the count a whole number from 1 to 1000", option, text));
  for (int i = 0; i < static_cast<int>(count); ++i, value *= ratio) values.push_back(value);
  return values;
}

}  // namespace odemark
