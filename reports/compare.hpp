// Two or more results files side by side: what got better, what worse, and what only one of them has.
#pragma once

#include <string>
#include <vector>

#include "bench/data/row.hpp"
#include "bench/data/stability.hpp"
#include "reports/table.hpp"

namespace odemark {

struct NamedRows {
  std::string name;
  std::vector<Row> rows;
  std::vector<StabilityRow> stability{};
};

enum class CompareFilter { all, regressed, improved, changed };

struct CompareOptions {
  double error_factor = 1.1;
  double floor = 1e-13;  // smaller differences of errors are round-off; wider in float
  double evaluations_factor = 1.05;
  double time_factor = 1.3;
  double order_slack = 0.1;
};

struct Comparison {
  Table runs;                                              // matched by id: errors, evaluations, times
  Table orders;                                            // per method and problem
  Table limits;                                            // largest stable dt, per method and problem
  Table one_side;                                          // runs and limits that only one of the files has
  int regressed = 0, improved = 0, changed = 0, same = 0;  // runs and limits, before the filter
};

/// The first is what the others are compared with. Throws std::invalid_argument for fewer than two.
Comparison compare(const std::vector<NamedRows>& sets, CompareFilter filter = CompareFilter::all,
                   const CompareOptions& options = {});

}  // namespace odemark
