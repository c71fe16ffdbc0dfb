// Typed values out of a TOML file, or BadThresholds with the line: what the reader of thresholds.toml is made
// of.
#pragma once

#include <toml++/toml.h>

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "reports/thresholds.hpp"

namespace odemark {

inline int line_of(const toml::node& node) { return static_cast<int>(node.source().begin.line); }
inline bool is_off(const toml::node& node) { return node.is_string() && node.as_string()->get() == "off"; }

struct TomlReader {
  std::string name;  // of the file

  [[noreturn]] void refuse(int line, const std::string& why) const;
  [[noreturn]] void unknown(const toml::key& key, std::string_view where, std::string_view known) const;

  double number(const toml::node& node, std::string_view key) const;
  double positive(const toml::node& node, std::string_view key) const;
  double factor(const toml::node& node, std::string_view key) const;  // 1 or more
  bool flag(const toml::node& node, std::string_view key) const;
  std::string text(const toml::node& node, std::string_view key) const;
  std::string date(const toml::node& node, std::string_view key) const;  // YYYY-MM-DD
  std::string one_of(const toml::node& node, std::string_view key,
                     std::initializer_list<std::string_view> known) const;
  std::vector<std::string> texts(const toml::node& node, std::string_view key) const;  // one or a list
  const toml::table& table(const toml::node& node, std::string_view key, std::string_view how) const;
  const toml::node& needed(const toml::table& table, std::string_view key, std::string_view where) const;

  /// Takes a key that selects runs; false for any other.
  bool selects(RunSelector& runs, bool& chosen, const toml::key& key, const toml::node& node) const;
};

}  // namespace odemark
