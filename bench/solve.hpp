// One run of a method on a problem as it is: over its switches and events too.
#pragma once

#include "integrators/integrate_events.hpp"
#include "reference/any_problem.hpp"

namespace odemark {

/// Whether a run has to mind the pieces of a problem: error control stops at switches and events, fixed steps
/// only meet jumps. Where it has not, the plain loops of the method are the run.
bool in_pieces(const AnyProblem& problem, const Control& control);

/// `counts` may be null. `found` is what happened on the way; kinks that fixed steps walk over are noticed
/// too.
template <class T>
RunReport solve_problem(const AnyMethod& method, const AnyProblem& problem, const Control& control,
                        std::vector<T>& y, Trace<T>& trace, std::vector<FoundEvent>& found,
                        WorkCounts* counts);

}  // namespace odemark
