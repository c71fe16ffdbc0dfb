// Step sizes or tolerances as people type them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace odemark {

/// "0.1:0.5:10" is ten values from 0.1, each half the one before; or a list "0.1,0.05"; quotients like 1/60
/// are fine. Throws BadInput with the name of the option.
std::vector<double> parse_ladder(std::string_view option, const std::string& text);

}  // namespace odemark
