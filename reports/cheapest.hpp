// The cheapest way to an error: interpolated along measured curves, never beyond them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "reports/table.hpp"
#include "reports/work_curves.hpp"

namespace odemark {

inline constexpr double target_errors[] = {1e-2, 1e-3, 1e-6, 1e-9};

/// What a method asks for an error.
struct Offer {
  std::string label, method, tier;
  bool adaptive = false;
  double cost = 0;
  double control = 0;    // dt or tolerance that gives the error
  bool at_most = false;  // the coarsest run that worked is already this good: the true cost is at most this
};

/// From this cost on every finer run that the ladder has stays below `error`, until round-off. Interpolated
/// between two runs on logarithmic axes; after a failed run the next finer one counts as it is. Absent where
/// the curve never gets there, or where `error` is below what the truth can tell.
std::optional<Offer> offer_of(const WorkCurve& curve, double error, Cost cost);

/// The offers of all curves, cheapest first; of a method with several curves only the cheapest.
std::vector<Offer> cheapest(const ProblemCurves& problem, double error, Cost cost);

/// "dt 0.0123" or "tol 1e-07"
std::string control_text(const Offer& offer);
/// "312 evaluations" or "1.23 µs"
std::string cost_text(const Offer& offer, Cost cost);

/// "10⁻⁶"
std::string target_text(double error);

/// One line per problem and target error: who is cheapest, with which control, and who comes second.
Table cheapest_table(const std::vector<ProblemCurves>& problems, Cost cost);

}  // namespace odemark
