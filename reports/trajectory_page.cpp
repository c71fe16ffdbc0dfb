// Trajectories as a chart: over time, or in a plane.
#include "reports/trajectory_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "reports/format.hpp"

namespace odemark {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

struct Window {
  double low = infinity, high = -infinity;

  void see(double x) { low = std::min(low, x), high = std::max(high, x); }
  Range widened(double part) const {
    const double spread = high > low ? high - low : std::max(std::abs(high), 1.0);
    return {low - part * spread, high + part * spread};
  }
};

bool inside(const Range& range, double x) { return x >= range.low && x <= range.high; }

/// The points until just after the curve has left the frame for the first time.
std::vector<Point> until_it_leaves(const std::vector<double>& x, const std::vector<double>& y,
                                   const Range& x_range, const Range& y_range, bool& left) {
  std::vector<Point> points;
  for (std::size_t i = 0; i < std::min(x.size(), y.size()); ++i) {
    if (!std::isfinite(x[i]) || !std::isfinite(y[i])) break;
    const bool in = inside(x_range, x[i]) && inside(y_range, y[i]);
    points.push_back({x[i], y[i]});
    if (!in) {
      left = true;
      break;
    }
  }
  return points;
}

std::string axis_label(const Trajectory& of) {
  return of.unit.empty() ? of.component : fmt::format("{} [{}]", of.component, of.unit);
}

}  // namespace

Chart trajectory_chart(const Scene& scene, const Palette& palette) {
  const bool plane = !scene.x.empty();
  Chart chart{.id = scene.problem + "-trajectory",
              .title = scene.problem + (plane ? ": the path" : ": over time"),
              .caption = ""};
  chart.equal_aspect = plane;
  Window x_window, y_window;
  if (!scene.exact.empty()) {
    const Trajectory& y = scene.exact.back();
    const auto& x = plane ? scene.exact.front().value : y.t;
    Series exact{"exact", "exact", "", {}, {.colour = 4, .marker = Marker::none, .line = Line::solid}};
    for (std::size_t i = 0; i < y.value.size(); ++i) {
      exact.points.push_back({x[i], y.value[i]});
      x_window.see(x[i]), y_window.see(y.value[i]);
    }
    chart.series.push_back(std::move(exact));
  } else {
    for (const auto& run : scene.runs)
      for (std::size_t i = 0; i < run.y.value.size() && i < 1000; ++i)
        if (std::abs(run.y.value[i]) < 1e6)
          x_window.see(run.x ? run.x->value[i] : run.y.t[i]), y_window.see(run.y.value[i]);
  }
  if (scene.runs.empty() && scene.exact.empty()) return chart;
  const Range x_range = x_window.widened(plane ? 0.35 : 0), y_range = y_window.widened(0.35);
  chart.x.range = x_range, chart.y.range = y_range;
  std::string gone;
  double dt = 0;
  for (const auto& run : scene.runs) {
    bool left = false;
    Series series{run.method, run.method, "", {}, palette.style_of(run.method)};
    series.points = until_it_leaves(run.x ? run.x->value : run.y.t, run.y.value, x_range, y_range, left);
    if (series.points.size() > 60) series.style.marker = Marker::none;
    if (left) gone += fmt::format("{}{}", gone.empty() ? "" : ", ", run.method);
    dt = run.dt;
    chart.series.push_back(std::move(series));
  }
  const Trajectory& named = scene.exact.empty() ? scene.runs.front().y : scene.exact.back();
  chart.y.label = axis_label(named);
  chart.x.label =
      plane ? axis_label(scene.exact.empty() ? *scene.runs.front().x : scene.exact.front()) : "t [s]";
  if (!scene.runs.empty()) chart.caption = fmt::format("All runs with dt = {} s.", compact(dt, 3));
  if (!gone.empty()) chart.caption += fmt::format(" {} left the picture, and the line ends there.", gone);
  if (!scene.exact_is.empty()) chart.caption += " Exact: " + scene.exact_is + ".";
  return chart;
}

}  // namespace odemark
