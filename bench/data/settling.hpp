// How step-size control behaves where stability, not accuracy, holds the step down. Plain data.
#pragma once

#include <string>

namespace odemark {

/// One explicit method under one step-size filter on y' = -2000 (y - cos t), tolerance 1e-3; see
/// bench/settling.hpp.
struct Settling {
  std::string method, filter, status;
  double limit = 0;    // end of the method's real stability interval, from its coefficients
  double mean = 0;     // of h |lambda| over the accepted steps of the second half
  double scatter = 0;  // standard deviation of these over their mean
  long accepted = 0, rejected = 0;
};

}  // namespace odemark
