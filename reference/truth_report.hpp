// The answer of `odemark truth`: the state at one time, with no digit that is not certain.
#pragma once

#include <optional>
#include <string>

#include "reference/truth.hpp"

namespace odemark {

struct TruthRequest {
  std::string problem = {}, settings = {};  // "kepler_e06", "e=0.7"
  std::optional<std::string> t = {};        // as typed; otherwise t_end
  int digits = 30;
  bool exact_inputs = false;  // T and all settings at their full decimal value
  bool json = false;
  double time_limit_seconds = 120;
};

/// Text or JSON for standard output. Throws BadInput and TruthUnavailable.
std::string truth_report(const std::vector<AnyFamily>& families, const TruthRequest& request);

}  // namespace odemark
