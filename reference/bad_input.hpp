// What a person typed wrong, in one sentence; main turns it into exit code 2.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace odemark {

/// The message names the offending thing and what would be right.
struct BadInput : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// ` (did you mean "rk4"?)` for the closest candidate by edit distance, or empty if none is close.
std::string suggestion(std::string_view typed, const std::vector<std::string>& candidates);

}  // namespace odemark
