// Error against step size: the picture of one problem, and what order every method shows.
#pragma once

#include <vector>

#include "bench/data/pictures.hpp"
#include "reports/chart.hpp"
#include "reports/observed_order.hpp"
#include "reports/table.hpp"
#include "reports/work_curves.hpp"

namespace odemark {

enum class Shown { best_of_family, all };

/// Error against dt on log-log axes, small dt left. Runs that did not reach the end stand hollow on the top
/// frame; the floor below which no error means anything is shaded.
Chart error_by_dt(const ProblemCurves& problem, const Palette& palette, Shown shown,
                  const std::vector<ObservedOrder>& orders, const ProblemCard* card);

/// How many order claims ended in each verdict.
struct OrderCounts {
  int holds = 0, fails = 0, exceeds = 0, inconclusive = 0;
  int total() const { return holds + fails + exceeds + inconclusive; }
};
OrderCounts count_orders(const std::vector<ObservedOrder>& orders);

/// Methods down, problems across: the slope that was measured, marked by its verdict.
Table order_matrix(const std::vector<ObservedOrder>& orders);

/// The claims that failed, with the fit window, the reason, and what the method says about itself.
Table failed_orders(const std::vector<ObservedOrder>& orders, const std::vector<MethodCard>& methods);

Status status_of(OrderVerdict verdict);

}  // namespace odemark
