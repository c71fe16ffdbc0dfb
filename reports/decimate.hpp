// Fewer points, same picture: keeps what the eye would miss, namely extremes, gaps and diverged points.
#pragma once

#include <cstddef>
#include <vector>

#include "reports/chart.hpp"

namespace odemark {

inline constexpr std::size_t points_per_series = 200;

// At most max_points (but at least 8), in the original order: the first and last point, and of each stretch
// the lowest and the highest (for curves that turn back in x also the leftmost and rightmost), one gap and
// one diverged point if it has any.
std::vector<Point> decimate(const std::vector<Point>& points, std::size_t max_points = points_per_series);

Chart decimated(Chart chart, std::size_t max_points = points_per_series);

}  // namespace odemark
