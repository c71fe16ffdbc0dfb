// Number types: where round-off takes over, in float, double and long double, with plain and compensated
// sums.
#pragma once

#include <string>
#include <vector>

#include "bench/data/row.hpp"
#include "reports/chart.hpp"
#include "reports/observed_order.hpp"
#include "reports/table.hpp"

namespace odemark {

/// The curves that a comparison of number types is about: fixed steps, of problems on which more than one
/// number type or kind of sum was run.
std::vector<ObservedOrder> precision_orders(const std::vector<Row>& rows);

/// Methods down, number types across: the dt below which more steps no longer help.
Table roundoff_table(const std::vector<ObservedOrder>& orders, const std::string& problem);

/// Error against dt of a few methods in every number type.
Chart precision_chart(const std::vector<ObservedOrder>& orders, const std::string& problem);

/// One sentence about a problem; empty where nothing was found.
std::string precision_answer(const std::vector<ObservedOrder>& orders, const std::string& problem);

std::vector<std::string> precision_problems(const std::vector<ObservedOrder>& orders);

}  // namespace odemark
