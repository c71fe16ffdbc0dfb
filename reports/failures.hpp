// Runs that did not reach the end: none is dropped, each has its reason.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "bench/data/row.hpp"
#include "reports/table.hpp"

namespace odemark {

/// Status to number of runs, of runs that were made and did not reach the end.
std::map<std::string, int> failures_by_status(const std::vector<Row>& rows);

/// One line per problem, method, number type and status: at which steps or tolerances, and why.
Table failure_table(const std::vector<Row>& rows);

/// Pairs that cannot be run, by reason.
Table not_applicable_table(const std::vector<Row>& rows);

/// Runs that reached the end but have no error, because no truth could be certified.
Table without_truth_table(const std::vector<Row>& rows);

}  // namespace odemark
