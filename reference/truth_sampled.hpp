// The truth of a problem too large to be computed, kept or compared whole: its closed form at some
// components.
#pragma once

#include "reference/truth.hpp"

namespace odemark {

/// Every component of a problem that is not large; of a large one a few hundred, evenly spread over each half
/// of the state, both ends of a half among them.
std::vector<std::size_t> compared_components(const AnyProblem& problem);

/// At the end of the interval only. The bound is that of rounding the initial state to double, carried along.
/// Throws TruthUnavailable where the family has no closed form of this kind.
Truth sampled_truth(const AnyProblem& problem);

}  // namespace odemark
