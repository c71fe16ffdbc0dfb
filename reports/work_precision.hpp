// Error against what it costs: pictures of one problem, and every method in one table.
#pragma once

#include <vector>

#include "reports/chart.hpp"
#include "reports/observed_order.hpp"
#include "reports/table.hpp"
#include "reports/work_curves.hpp"

namespace odemark {

/// Error on y, cost on x; dashed: the method chooses its own steps.
Chart error_by_cost(const ProblemCurves& problem, const Palette& palette, Cost cost);

/// Every curve of a problem: order, smallest error, cost of three errors. Cheapest to 1e-6 first.
Table method_table(const ProblemCurves& problem, const std::vector<ObservedOrder>& orders);

/// "To 1e-6, heun needs the fewest evaluations (312) and rk4 the least time (1.2 µs per simulated second)."
std::string answer(const ProblemCurves& problem);

/// Methods down, problems across: digits reached, and the time to 1e-6 as a multiple of the fastest.
Table overview(const std::vector<ProblemCurves>& problems);

}  // namespace odemark
