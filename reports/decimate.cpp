// Fewer points, same picture: keeps what the eye would miss, namely extremes, gaps and diverged points.
#include "reports/decimate.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace odemark {
namespace {

bool is_gap(const Point& p) { return !p.diverged && (!std::isfinite(p.x) || !std::isfinite(p.y)); }

bool turns_back(const std::vector<Point>& points) {
  bool rises = false;
  bool falls = false;
  for (std::size_t i = 1; i < points.size(); ++i) {
    rises = rises || points[i].x > points[i - 1].x;
    falls = falls || points[i].x < points[i - 1].x;
  }
  return rises && falls;
}

// The points of [begin, end) worth keeping, by index.
std::vector<std::size_t> keepers(const std::vector<Point>& points, std::size_t begin, std::size_t end,
                                 bool both_axes) {
  std::optional<std::size_t> low, high, left, right, gap, diverged;
  for (std::size_t i = begin; i < end; ++i) {
    const Point& p = points[i];
    if (p.diverged) {
      if (!diverged) diverged = i;
    } else if (is_gap(p)) {
      if (!gap) gap = i;
    } else {
      if (!low || p.y < points[*low].y) low = i;
      if (!high || p.y > points[*high].y) high = i;
      if (both_axes && (!left || p.x < points[*left].x)) left = i;
      if (both_axes && (!right || p.x > points[*right].x)) right = i;
    }
  }
  std::vector<std::size_t> kept;
  for (const auto& index : {low, high, left, right, gap, diverged}) {
    if (index) kept.push_back(*index);
  }
  std::sort(kept.begin(), kept.end());
  kept.erase(std::unique(kept.begin(), kept.end()), kept.end());
  return kept;
}

}  // namespace

std::vector<Point> decimate(const std::vector<Point>& points, std::size_t max_points) {
  const std::size_t limit = std::max<std::size_t>(max_points, 8);
  if (points.size() <= limit) return points;
  const bool both_axes = turns_back(points);
  const bool has_gap = std::any_of(points.begin(), points.end(), is_gap);
  const bool has_diverged =
      std::any_of(points.begin(), points.end(), [](const Point& p) { return p.diverged; });
  const std::size_t per_stretch = (both_axes ? 4u : 2u) + (has_gap ? 1u : 0u) + (has_diverged ? 1u : 0u);
  const std::size_t stretches = std::max<std::size_t>((limit - 2) / per_stretch, 1);
  const std::size_t inner = points.size() - 2;
  std::vector<Point> kept{points.front()};
  for (std::size_t s = 0; s < stretches; ++s) {
    const std::size_t begin = 1 + inner * s / stretches;
    const std::size_t end = 1 + inner * (s + 1) / stretches;
    for (const std::size_t i : keepers(points, begin, end, both_axes)) kept.push_back(points[i]);
  }
  kept.push_back(points.back());
  return kept;
}

Chart decimated(Chart chart, std::size_t max_points) {
  for (Series& series : chart.series) series.points = decimate(series.points, max_points);
  return chart;
}

}  // namespace odemark
