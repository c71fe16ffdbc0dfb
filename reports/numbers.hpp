// The two numbers that are none: what is not known, and what has no end.
#pragma once

#include <limits>

namespace odemark {

inline constexpr double absent = std::numeric_limits<double>::quiet_NaN();
inline constexpr double infinity = std::numeric_limits<double>::infinity();

}  // namespace odemark
