// Which two solvers for which problem.
#pragma once

#include <memory>
#include <string_view>
#include <utility>

#include "reference/truth.hpp"
#include "reference/truth_solver.hpp"

namespace odemark {

enum class TruthOrigin { closed_form, taylor, extrapolation, radau, lobatto };

/// Throws BadInput for a name that CertifyOptions does not know.
TruthOrigin truth_origin(std::string_view name);

/// A solver whose local errors stay below 10^exponent; not for closed forms.
std::unique_ptr<TruthSolver> make_truth_solver(TruthOrigin origin, double exponent,
                                               const std::vector<double>& scale);

/// What a quick implicit run at low accuracy tells about the way to `end`.
struct Workload {
  double steps = 0;       // that it took, or would have taken
  double stiffness = 0;   // the integral of the spectral radius of the Jacobian
  double products = 0;    // operations on the tape that cost a convolution
  double entries = 0;     // all operations on it
  double evaluation = 0;  // the cost of one evaluation, in multiplications
  bool kinks = false;     // abs on the tape
};
Workload survey(const WideProblem& problem, const Wide& end, const std::vector<double>& scale);

/// Seconds, roughly: solvers are ranked by it.
double expected_seconds(TruthOrigin origin, const Workload& work, std::size_t size, double exponent);

/// The closed form and the cheapest solver; without closed form the cheapest pair of Taylor with
/// extrapolation, Taylor with Radau, Radau with Lobatto (these share Newton's method, so only where the
/// others take long). What the options name is kept.
std::pair<TruthOrigin, TruthOrigin> choose_origins(const WideProblem& problem, const Workload& work,
                                                   double exponent, const CertifyOptions& options);

}  // namespace odemark
