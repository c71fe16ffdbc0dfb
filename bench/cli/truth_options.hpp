// The options of odemark truth.
#pragma once

#include <CLI/CLI.hpp>

#include "bench/cli/commands.hpp"

namespace odemark {

/// `presets` and `t` are filled when `app` has parsed the command line.
void add_truth_options(CLI::App& app, TruthCommandOptions& truth, std::vector<std::string>& presets,
                       std::string& t);

/// One problem to solve, or presets to verify. Throws BadInput where it is neither.
void settle_truth(TruthCommandOptions& truth, const std::vector<std::string>& presets);

}  // namespace odemark
