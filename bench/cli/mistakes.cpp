// CLI11 would print the limits of a double, or the inside of a map.
#include "bench/cli/mistakes.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

#include "reference/bad_input.hpp"

namespace odemark {

namespace {

/// The whole text as a number, or nothing.
template <class T>
std::optional<T> number_in(const std::string& text) {
  T value{};
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc{} || stop != end) return std::nullopt;
  return value;
}

}  // namespace

CLI::Validator above_zero(std::string what) {
  return {[what = std::move(what)](std::string& text) -> std::string {
            const auto value = number_in<double>(text);
            if (value && *value > 0 && std::isfinite(*value)) return "";
            return fmt::format("\"{}\" is no number of {}: it must be above 0, like 2.5", text, what);
          },
          ""};
}

CLI::Validator whole_number(std::string what, long least, long most) {
  return {[what = std::move(what), least, most](std::string& text) -> std::string {
            const auto value = number_in<long>(text);
            if (value && *value >= least && *value <= most) return "";
            return fmt::format("\"{}\" is no number of {}: {} to {}", text, what, least, most);
          },
          ""};
}

CLI::Validator one_of(std::string what, std::vector<std::string> names) {
  return {[what = std::move(what), names = std::move(names)](std::string& text) -> std::string {
            if (std::find(names.begin(), names.end(), text) != names.end()) return "";
            return fmt::format("there is no {} \"{}\"{}: {}", what, text, suggestion(text, names),
                               fmt::join(names, ", "));
          },
          ""};
}

CLI::Validator something() {
  return {[](std::string& text) -> std::string {
            return text.empty() ? "nothing is given: leave the option out for the default" : "";
          },
          ""};
}

std::string unexpected_words(const CLI::App& app) {
  const auto chosen = app.get_subcommands();
  const CLI::App& command = chosen.empty() ? app : *chosen.front();
  const auto words = command.remaining();
  if (words.empty()) return "";
  const auto option =
      std::find_if(words.begin(), words.end(), [](const std::string& w) { return w.starts_with("-"); });
  if (option == words.end())
    return fmt::format("{} does not take \"{}\": `odemark {} --help` shows what it takes", command.get_name(),
                       words.front(), command.get_name());
  const std::string typed = option->substr(0, option->find('='));
  std::vector<std::string> known;
  for (const CLI::Option* one : command.get_options())
    for (const auto& name : one->get_lnames()) known.push_back("--" + name);
  if (&command == &app)
    return fmt::format("there is no option {}{}: `odemark --help` shows them", typed,
                       suggestion(typed, known));
  return fmt::format("{0} has no option {1}{2}: `odemark {0} --help` shows them", command.get_name(), typed,
                     suggestion(typed, known));
}

}  // namespace odemark
