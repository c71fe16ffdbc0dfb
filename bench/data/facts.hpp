// What is known of one method: facts of its coefficients, and the same measured from its compiled step. Plain
// data.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "bench/data/region.hpp"

namespace odemark {

/// coefficient * y^power.
struct FactPower {
  double coefficient = 0;
  int power = 0;
};

using FactIntervals = std::vector<std::pair<double, double>>;     // an end may be infinite
using FactNumbers = std::vector<std::pair<std::string, double>>;  // by name
using FactValue = std::variant<std::monostate, bool, int, double, FactPower, FactIntervals, FactNumbers>;

struct FactLine {
  std::string key;
  FactValue value;   // monostate: there is none, for the reason in `note`
  std::string note;  // beside a value: how it is meant or known
};

/// One fact from the compiled stepper beside theory.
struct MeasuredFact {
  std::string fact, scalar;  // "float" or "double"
  std::optional<double> theory, measured;
  std::optional<double> difference, bound;  // |difference| <= bound is agreement
  bool agrees = true;
  std::string note;  // what was done, where it differs most, or why it could not be measured
};

struct FactSheet {
  std::string id, name, family, provider, source, advice;
  std::vector<FactLine> facts;
  std::vector<MeasuredFact> measured;
  std::optional<StabilityRegion> region;
};

}  // namespace odemark
