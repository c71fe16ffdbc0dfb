// From two computations to what is certain.
#pragma once

#include "reference/truth.hpp"
#include "reference/wide_problem.hpp"

namespace odemark {

/// The state `a` with the bounds that its distance from `b` allows: ten times the distance of the component,
/// and no less than the distance of the worst component in its scale, relative to the value (an agreement by
/// luck is no agreement), and no less than what wide arithmetic leaves.
TruthPoint compare(const Wide& t, const std::vector<Wide>& a, const std::vector<Wide>& b,
                   const std::vector<double>& scale);
/// The events of the first, whose phases may not be known, with bounds by their distance from the second's.
/// Throws RunFailed where the two found different ones.
std::vector<TruthEvent> compare(const std::vector<WideEvent>& a, const std::vector<WideEvent>& b);
/// A value that is known to `bound`.
TruthValue truth_value(const Wide& value, const Wide& bound);
/// Reads `hi` and `lo` from the decimal, and the digits from the bound.
TruthValue truth_value(const std::string& decimal, long double bound);
/// Digits in units of the scale: of the worst component.
int digits_in_scale(const std::vector<TruthValue>& values, const std::vector<double>& scale);
/// The digits on which value - bound and value + bound agree, at most `most`: every digit printed is right.
/// "0" where not even the first is known.
std::string certain_digits(const TruthValue& value, int most);

}  // namespace odemark
