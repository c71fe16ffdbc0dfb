// What a tolerance means: achieved against requested error, proportionality, rejected work, deceived steps.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bench/data/row.hpp"
#include "reports/table.hpp"

namespace odemark {

/// One code on one problem over its tolerances.
struct Calibration {
  struct Point {
    double requested, achieved;
  };
  std::string problem, method, provider, filter;
  std::vector<Point> points;  // of runs that reached the end, coarse to fine
  std::optional<double>
      slope;  // of log achieved over log requested where it is above round-off; three runs or more
  std::optional<double> expected_slope;  // order / (order of the estimate); absent where the order varies
  long accepted = 0, rejected = 0;
  long judged = 0,
       deceived = 0;           // steps whose true local error is known, and those where it is above tolerance
  double worst_deception = 0;  // largest true local error over tolerance
  std::vector<std::string> failures;  // statuses of the other runs

  double rejected_share() const;
  /// Smallest and largest achieved / requested.
  double least_ratio() const, most_ratio() const;
};

/// Rows under error control, in the order of their first rows.
std::vector<Calibration> calibrations(const std::vector<Row>& rows);

Table calibration_table(const std::vector<Calibration>& codes);

}  // namespace odemark
