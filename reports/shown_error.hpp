// Which error of a run curves and tables show.
#pragma once

#include "bench/data/row.hpp"
#include "reports/numbers.hpp"

namespace odemark {

/// What is left of the motion at the end is next to nothing: any error is small there.
inline bool dies_before_the_end(const Row& row) { return row.errors && row.errors->left.has_value(); }

/// In the scale of the problem, at the end; over the whole time where the motion has died by then. NaN where
/// there is none.
inline double shown_error(const Row& row) {
  if (!row.errors) return absent;
  return dies_before_the_end(row) && row.errors->trajectory_max ? *row.errors->trajectory_max
                                                                : row.errors->scaled;
}

}  // namespace odemark
