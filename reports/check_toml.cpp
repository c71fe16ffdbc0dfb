// Typed TOML values, and the globs that thresholds match cases with.
#include "reports/check_toml.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace odemark {

void TomlReader::refuse(int line, const std::string& why) const {
  throw BadThresholds(fmt::format("{}:{}: {}", name, line, why));
}

void TomlReader::unknown(const toml::key& key, std::string_view where, std::string_view known) const {
  refuse(static_cast<int>(key.source().begin.line),
         fmt::format("unknown key \"{}\" in {}: known are {}", key.str(), where, known));
}

double TomlReader::number(const toml::node& node, std::string_view key) const {
  const auto value = node.value<double>();
  if (!node.is_number() || !value || !std::isfinite(*value))
    refuse(line_of(node), fmt::format("{} must be a finite number", key));
  return *value;
}

double TomlReader::positive(const toml::node& node, std::string_view key) const {
  const double value = number(node, key);
  if (!(value > 0)) refuse(line_of(node), fmt::format("{} must be above 0, not {}", key, value));
  return value;
}

double TomlReader::factor(const toml::node& node, std::string_view key) const {
  const double value = number(node, key);
  if (!(value >= 1)) refuse(line_of(node), fmt::format("{} is a factor of 1 or more, not {}", key, value));
  return value;
}

bool TomlReader::flag(const toml::node& node, std::string_view key) const {
  if (!node.is_boolean()) refuse(line_of(node), fmt::format("{} must be true or false", key));
  return node.as_boolean()->get();
}

std::string TomlReader::text(const toml::node& node, std::string_view key) const {
  if (!node.is_string() || node.as_string()->get().empty())
    refuse(line_of(node), fmt::format("{} must be a text in quotes", key));
  return node.as_string()->get();
}

std::string TomlReader::date(const toml::node& node, std::string_view key) const {
  if (!node.is_date()) refuse(line_of(node), fmt::format("{} is a date without quotes: 2030-12-31", key));
  const toml::date day = node.as_date()->get();
  return fmt::format("{:04}-{:02}-{:02}", day.year, int{day.month}, int{day.day});
}

std::string TomlReader::one_of(const toml::node& node, std::string_view key,
                               std::initializer_list<std::string_view> known) const {
  const std::string value = text(node, key);
  if (std::find(known.begin(), known.end(), value) == known.end())
    refuse(line_of(node), fmt::format("{} = \"{}\" is not known: {}", key, value, fmt::join(known, ", ")));
  return value;
}

std::vector<std::string> TomlReader::texts(const toml::node& node, std::string_view key) const {
  if (!node.is_array()) return {text(node, key)};
  std::vector<std::string> all;
  for (const auto& element : *node.as_array()) all.push_back(text(element, key));
  if (all.empty()) refuse(line_of(node), fmt::format("{} names nothing", key));
  return all;
}

const toml::table& TomlReader::table(const toml::node& node, std::string_view key,
                                     std::string_view how) const {
  if (!node.is_table()) refuse(line_of(node), fmt::format("{} is written {}", key, how));
  return *node.as_table();
}

const toml::node& TomlReader::needed(const toml::table& table, std::string_view key,
                                     std::string_view where) const {
  const toml::node* const node = table.get(key);
  if (!node) refuse(line_of(table), fmt::format("{} needs {}", where, key));
  return *node;
}

bool TomlReader::selects(RunSelector& runs, bool& chosen, const toml::key& key,
                         const toml::node& node) const {
  using Kind = RunSelector::Kind;
  constexpr std::array<std::pair<std::string_view, Kind>, 5> kinds{{{"at_dt", Kind::at_dt},
                                                                    {"up_to_dt", Kind::up_to_dt},
                                                                    {"from_dt", Kind::from_dt},
                                                                    {"at_steps", Kind::at_steps},
                                                                    {"at_tol", Kind::at_tol}}};
  RunSelector found;
  if (key == "at") {
    found.kind = one_of(node, "at", {"finest", "every"}) == "finest" ? Kind::finest : Kind::every;
  } else {
    const auto kind = std::find_if(kinds.begin(), kinds.end(), [&](const auto& k) { return key == k.first; });
    if (kind == kinds.end()) return false;
    found = {kind->second, positive(node, key.str())};
  }
  if (chosen) refuse(line_of(node), "a demand selects its runs by one key, not by two");
  runs = found, chosen = true;
  return true;
}

bool is_glob(std::string_view text) { return text.find_first_of("*?") != text.npos; }

bool matches_glob(std::string_view glob, std::string_view text) {
  std::size_t g = 0, t = 0, star = glob.npos, resume = 0;
  while (t < text.size()) {
    if (g < glob.size() && glob[g] == '*') {
      star = g++, resume = t;
    } else if (g < glob.size() && (glob[g] == '?' || glob[g] == text[t])) {
      ++g, ++t;
    } else if (star != glob.npos) {
      g = star + 1, t = ++resume;
    } else {
      return false;
    }
  }
  return glob.find_first_not_of('*', g) == glob.npos;
}

}  // namespace odemark
