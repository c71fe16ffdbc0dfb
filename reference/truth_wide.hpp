// Certification of a problem in wide arithmetic: what `certify` and the command behind it rest on.
#pragma once

#include "reference/truth.hpp"
#include "reference/wide_problem.hpp"

namespace odemark {

/// The problem in wide arithmetic; throws TruthUnavailable for a family outside the suite.
WideProblem widened(const AnyProblem& problem, bool exact_inputs);

/// Throws BadInput for a number of digits that cannot be certified at all.
void check_digits(int digits);

/// `first` and `second` are the same problem; tests plant a difference to see that it is found.
Truth certify_wide(const AnyProblem& problem, const WideProblem& first, const WideProblem& second,
                   const std::vector<Wide>& times, const CertifyOptions& options);

/// The closed form as it stands, where no second computation is affordable: its bound is a claim.
Truth unchecked_closed_form(const AnyProblem& problem, const WideProblem& wide,
                            const std::vector<Wide>& times);

}  // namespace odemark
