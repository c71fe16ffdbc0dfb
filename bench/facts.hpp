// The sheet of facts of a method, for printing: every key in one place.
#pragma once

#include "bench/data/facts.hpp"
#include "integrators/any_method.hpp"
#include "integrators/facts.hpp"

namespace odemark {

FactSheet fact_sheet(const AnyMethod& method);

/// A claim that its own coefficients contradict: one sentence each; empty when all is well.
std::vector<std::string> claim_faults(const AnyMethod& method);

/// One object: null where a notion does not apply, with the sentence in "reasons"; "infinity" where there is
/// no end; sentences about values in "notes".
std::string to_json(const FactSheet& sheet, int indent = 2);

}  // namespace odemark
