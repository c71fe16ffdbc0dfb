// Pictures of stability regions, with where the problems lie in them.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "reports/format.hpp"
#include "reports/stability_page.hpp"

namespace odemark {
namespace {

constexpr double coarsest = 8;  // step ladders begin at this many times the suggested dt

/// A tenth of a thousandth of the picture apart is close enough to drop a point.
std::vector<Position> thinned(const std::vector<std::complex<double>>& polygon, double width) {
  std::vector<Position> out;
  for (const auto& z : polygon) {
    const bool far =
        out.empty() || std::hypot(z.real() - out.back().x, z.imag() - out.back().y) > 0.012 * width;
    if (far) out.push_back({z.real(), z.imag()});
  }
  return out;
}

Series eigenvalue_dots(const std::vector<StabilityRow>& rows) {
  Series dots{"eigenvalues", fmt::format("problems: λ × {} suggested dt", compact(coarsest, 1)), "", {}, {}};
  dots.style = {.colour = 3, .marker = Marker::cross, .line = Line::none};
  std::set<std::string> seen;
  for (const auto& row : rows) {
    if (!seen.insert(row.problem).second) continue;
    for (const auto& lambda : row.eigenvalues)
      dots.points.push_back({lambda.real() * row.reference_dt * coarsest,
                             lambda.imag() * row.reference_dt * coarsest, false, row.problem});
  }
  return dots;
}

}  // namespace

std::vector<Chart> region_charts(const Pictures& pictures, const std::vector<StabilityRow>& rows,
                                 const Palette& palette) {
  std::vector<Chart> charts;
  for (const auto& group : pictures.regions) {
    Chart chart{.id = "region-" + group.id, .title = group.title, .caption = ""};
    chart.x.label = "Re λ dt";
    chart.y.label = "Im λ dt";
    chart.equal_aspect = true;
    std::string missing;
    int colour = 0;
    for (const auto& region : group.regions) {
      if (region.boundaries.empty()) {
        missing += fmt::format(" {}: {}.", region.method, region.reason);
        continue;
      }
      const double width = region.re_max - region.re_min, margin = width / 200;
      chart.x.range = {{region.re_min + margin, region.re_max - margin}};
      chart.y.range = {{region.im_min + margin, region.im_max - margin}};
      Region shape{region.method, region.method, "", {}, palette.style_of(region.method)};
      shape.style.colour = colour++;  // methods of one family lie in one picture here
      for (const auto& polygon : region.boundaries) shape.outlines.push_back(thinned(polygon, width));
      chart.regions.push_back(std::move(shape));
    }
    if (chart.regions.empty()) continue;
    chart.lines = {{Direction::vertical, 0, ""}, {Direction::horizontal, 0, ""}};
    chart.caption = "Shaded: |R(z)| ≤ 1, from the coefficients that step." + missing;
    if (Series dots = eigenvalue_dots(rows); charts.empty() && !dots.points.empty())
      chart.series.push_back(std::move(dots));
    charts.push_back(std::move(chart));
  }
  return charts;
}

}  // namespace odemark
