// What is said of options that are typed wrong: what was given, and what would be right, in one sentence.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace odemark {

/// A finite number above 0, "no number of seconds" where it is not.
CLI::Validator above_zero(std::string what);
/// A whole number from `least` to `most`.
CLI::Validator whole_number(std::string what, long least, long most);
/// One of the names: `what` is "format" or the like.
CLI::Validator one_of(std::string what, std::vector<std::string> names);

/// Anything but an empty text: a shell variable that was not set must not mean "everything".
CLI::Validator something();

/// The sentence for words that no option of the command takes, with the nearest option. Empty: there are
/// none.
std::string unexpected_words(const CLI::App& app);

}  // namespace odemark
