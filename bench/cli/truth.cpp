// odemark truth: the solution to many digits, or whether the stored ones still hold.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "bench/cli/commands.hpp"
#include "bench/cli/progress.hpp"
#include "reference/bad_input.hpp"

namespace odemark {

namespace {

nlohmann::ordered_json verified_json(const std::vector<VerifiedSolution>& all) {
  auto out = nlohmann::ordered_json::array();
  for (const auto& one : all)
    out.push_back({{"preset", one.preset},
                   {"digits", one.digits},
                   {"origin", one.origin},
                   {"checked_by", one.checked_by},
                   {"holds", one.fault.empty()},
                   {"fault", one.fault},
                   {"seconds", one.seconds}});
  return out;
}

int verify_stored(const Registry& registry, const TruthCommandOptions& options,
                  const std::atomic<bool>& stop) {
  Progress progress("stored solutions", options);
  const auto all = verify_solutions(
      registry.families, options.stored,
      [&](const VerifiedSolution& one, std::size_t done, std::size_t total) {
        progress.update(done, total, one.preset);
      },
      stop);
  std::size_t faults = 0;
  for (const auto& one : all) faults += one.fault.empty() ? 0 : 1;
  if (options.request.json) {
    fmt::print("{}\n", verified_json(all).dump(2));
  } else {
    for (const auto& one : all)
      if (one.fault.empty())
        fmt::print("{:<32} {} digits hold, {:.1f} s\n", one.preset, one.digits, one.seconds);
      else
        fmt::print("{:<32} FAILED: {}\n", one.preset, one.fault);
    fmt::print("{} stored solutions computed again: {} hold, {} do not\n", all.size(), all.size() - faults,
               faults);
  }
  if (faults > 0) return exit_failed;
  return stop ? exit_interrupted : exit_ok;
}

}  // namespace

int truth_command(const Registry& registry, const TruthCommandOptions& options,
                  const std::atomic<bool>& stop) {
  if (options.verify) return verify_stored(registry, options, stop);
  fmt::print("{}", truth_report(registry.families, options.request));
  return exit_ok;
}

}  // namespace odemark
