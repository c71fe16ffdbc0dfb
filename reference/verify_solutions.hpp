// Are the stored solutions still what two independent computations give?
#pragma once

#include <atomic>
#include <functional>
#include <optional>

#include "reference/truth_store.hpp"

namespace odemark {

struct VerifyRequest {
  std::vector<std::string> presets = {};   // empty: every preset of the families
  std::optional<std::size_t> sample = {};  // only so many of them, ...
  std::string seed = {};                   // ... chosen by this text: the same text, the same presets
  std::optional<double> within = {};       // only those that took up to so many seconds to compute
  std::size_t times = 16;                  // of each, spread over its stored times
  unsigned jobs = 1;
};

struct VerifiedSolution {
  std::string preset;
  int digits = 0;  // as stored
  std::string origin, checked_by, fault;
  double seconds = 0;  // that the check took
};

/// Called from one thread at a time.
using OnVerified = std::function<void(const VerifiedSolution&, std::size_t done, std::size_t total)>;

/// In the order of the catalogue; what `stop` kept from being checked is left out. Throws BadInput for a
/// preset that does not exist, and where no stored solution is left to check.
std::vector<VerifiedSolution> verify_solutions(const std::vector<AnyFamily>& families,
                                               const VerifyRequest& request, const OnVerified& report,
                                               const std::atomic<bool>& stop);

}  // namespace odemark
