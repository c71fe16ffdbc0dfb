// The order a method shows on a ladder of fixed steps, measured only where the error is neither round-off nor
// far from convergence; and the step below which round-off takes over.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bench/data/row.hpp"
#include "reports/verdict.hpp"

namespace odemark {

/// What one curve of error against dt is of.
struct CurveId {
  std::string problem, method, scalar;
  bool compensated = false;
  auto operator<=>(const CurveId&) const = default;
};

/// "problem/method", and " [float]" or " [double, compensated]" where that is not plain double.
std::string case_name(const CurveId& id);
CurveId curve_of(const Row& row);

struct OrderOptions {
  double slack = 0.3;           // the slope may lie this far below the claimed order
  double floor_factor = 100;    // of the floor: smaller errors are not used
  double largest_error = 0.1;   // scaled: larger errors are not used
  double slope_scatter = 0.15;  // largest difference of neighbouring local slopes
  int least_slopes = 3;         // in the window; two are enough where only three rungs are usable and agree
};

/// One rung of the ladder; a run without an error is a gap and not listed.
struct Rung {
  double dt = 0, error = 0, floor = 0;
  bool usable = false;
};

struct ObservedOrder {
  CurveId id;
  int claimed = 0;      // what is to be expected here; 0: nothing
  int stated = 0;       // of the method, where nothing lowers it
  std::string because;  // of a claim that is lower than stated
  OrderVerdict verdict = OrderVerdict::inconclusive;
  std::string reason;  // in words; never empty unless the order holds
  std::optional<double> slope, standard_error, dt_min, dt_max;
  int points = 0;             // in the window
  int usable = 0, gaps = 0;   // rungs between floor and largest error; runs that gave no error
  std::vector<Rung> rungs;    // from the largest dt to the smallest
  double log_error_at_1 = 0;  // of the fitted line: ln error = log_error_at_1 + slope ln dt
};

/// Rows of one curve in any order; rows without a step count are ignored, the first of equal dt is taken.
ObservedOrder observed_order(const std::vector<Row>& curve, const OrderOptions& options = {});

struct RoundoffOnset {
  CurveId id;
  std::optional<double> dt;  // where the error leaves the order line by a factor 2; absent: not reached
  std::optional<double> error_minimum, dt_at_minimum;
  bool beyond_ladder = false;  // the smallest error is that of the smallest dt: smaller steps still help
  std::string reason;          // where dt is absent or was not found from an order line
};

RoundoffOnset roundoff_onset(const ObservedOrder& order);

/// Every curve with at least one executed fixed-step run, in the order of its first row.
std::vector<ObservedOrder> observed_orders(const std::vector<Row>& rows, const OrderOptions& options = {});

/// The unit roundoff of "float", "double" or "long_double".
double unit_roundoff(std::string_view scalar);

}  // namespace odemark
