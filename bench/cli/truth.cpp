// odemark truth: the solution to many digits.
#include <fmt/format.h>

#include "bench/cli/commands.hpp"

namespace odemark {

int truth_command(const Registry& registry, const TruthRequest& request) {
  fmt::print("{}", truth_report(registry.families, request));
  return exit_ok;
}

}  // namespace odemark
