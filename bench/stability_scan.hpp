// Finds the stable intervals of dt of one step by scanning up from 0.
#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "bench/stability_growth.hpp"

namespace odemark {

struct ScanRange {
  double fastest_rate;  // 1/s
  double expected = 0;  // dt: the limit that theory names, 0 where it names none; sets the width of cells
  double last_expected = 0;  // dt: where theory's last finite band ends
};

/// What is scanned: the growth of a step, and what may be made of it.
struct ScanSubject {
  std::function<StepGrowth(double dt)> growth;
  std::function<double(double z)> tolerance;    // growth per step that counts as none
  std::function<long double(double dt)> noise;  // how far the growth may be off
  double floor;                                 // growth per step that is surely not rounding
};
ScanSubject subject_of(const StepProbe& probe);

struct Scan {
  std::string verdict;  // "limit", "unstable" or "unlimited"
  double limit = 0, resolution = 0, scanned_to = 0;
  std::vector<std::pair<double, double>> later_bands;
  std::string failure;
};

/// A doubling search would jump over gaps, so cells are narrow: at most 1 % of the expected limit and 0.02 /
/// fastest_rate up to it, later at most 0.5 % of dt. The scan goes on to 60 / fastest_rate, and for what is
/// stable so far, in steps of a fifth, to 1e6 / fastest_rate, or as far as the number type can tell.
Scan scan_step_sizes(const ScanSubject& subject, const ScanRange& range);

}  // namespace odemark
