// Trajectories as a chart: over time, or in a plane.
#include "reports/trajectory_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "reports/format.hpp"
#include "reports/numbers.hpp"
#include "reports/work_curves.hpp"

namespace odemark {
namespace {

struct Frame {
  double low = infinity, high = -infinity;

  void see(double x) { low = std::min(low, x), high = std::max(high, x); }
  AxisRange widened(double part) const {
    const double spread = high > low ? high - low : std::max(std::abs(high), 1.0);
    return {low - part * spread, high + part * spread};
  }
};

bool inside(const AxisRange& range, double x) { return x >= range.low && x <= range.high; }

/// The points until just after the curve has left the frame for the first time.
std::vector<Point> until_it_leaves(const std::vector<double>& x, const std::vector<double>& y,
                                   const AxisRange& x_range, const AxisRange& y_range, bool& left) {
  std::vector<Point> points;
  for (std::size_t i = 0; i < std::min(x.size(), y.size()); ++i) {
    if (!std::isfinite(x[i]) || !std::isfinite(y[i])) break;
    const bool in = inside(x_range, x[i]) && inside(y_range, y[i]);
    points.push_back({rounded(x[i]), rounded(y[i])});
    if (!in) {
      left = true;
      break;
    }
  }
  return points;
}

void see_runs(const Scene& scene, double largest, Frame& x_window, Frame& y_window) {
  for (const auto& run : scene.runs)
    for (std::size_t i = 0; i < run.y.value.size(); ++i)
      if (std::abs(run.y.value[i]) < largest)
        x_window.see(run.x ? run.x->value[i] : run.y.t[i]), y_window.see(run.y.value[i]);
}

/// Widens the windows to the runs, but not beyond the ranges.
void see_runs_within(const Scene& scene, const AxisRange& x_range, const AxisRange& y_range, Frame& x_window,
                     Frame& y_window) {
  for (const auto& run : scene.runs)
    for (std::size_t i = 0; i < run.y.value.size(); ++i) {
      const double x = run.x ? run.x->value[i] : run.y.t[i], y = run.y.value[i];
      if (!std::isfinite(x) || !std::isfinite(y)) break;
      x_window.see(std::clamp(x, x_range.low, x_range.high));
      y_window.see(std::clamp(y, y_range.low, y_range.high));
      if (!inside(x_range, x) || !inside(y_range, y)) break;
    }
}

std::string axis_label(const Trajectory& of) {
  return of.unit.empty() ? of.component : fmt::format("{} [{}]", of.component, of.unit);
}

}  // namespace

Chart trajectory_chart(const Scene& scene) {
  const bool plane = !scene.x.empty();
  Chart chart{.id = scene.problem + "-trajectory",
              .title = scene.problem + (plane ? ": the path" : ": over time"),
              .caption = ""};
  chart.equal_aspect = plane;
  if (scene.runs.empty() && scene.exact.empty()) return chart;
  Frame x_window, y_window;
  if (!scene.exact.empty()) {
    const Trajectory& y = scene.exact.back();
    const auto& x = plane ? scene.exact.front().value : y.t;
    Series exact{"exact", "exact", "", {}, {.colour = 4, .marker = Marker::none, .line = Line::solid}};
    for (std::size_t i = 0; i < y.value.size(); ++i) {
      exact.points.push_back({rounded(x[i]), rounded(y.value[i])});
      x_window.see(x[i]), y_window.see(y.value[i]);
    }
    chart.series.push_back(std::move(exact));
  } else {
    see_runs(scene, 1e6, x_window, y_window);
  }
  const AxisRange x_exact = x_window.widened(plane ? 0.4 : 0), y_exact = y_window.widened(0.4);
  see_runs_within(scene, x_exact, y_exact, x_window, y_window);
  const AxisRange x_range = x_window.widened(plane ? 0.05 : 0), y_range = y_window.widened(0.05);
  chart.x.range = x_range, chart.y.range = y_range;
  std::string gone;
  int colour = 0;
  for (const auto& run : scene.runs) {
    bool left = false;
    Series series{run.method, run.method, "", {}, {}};
    // methods of one family lie close together here: colours of their own, and a line style for every two
    series.style = {.colour = colour == 4 ? ++colour : colour, .marker = Marker::none, .line = Line::dashed};
    ++colour;
    series.points = until_it_leaves(run.x ? run.x->value : run.y.t, run.y.value, x_range, y_range, left);
    if (left) gone += fmt::format("{}{}", gone.empty() ? "" : ", ", run.method);
    chart.series.push_back(std::move(series));
  }
  const Trajectory& named = scene.exact.empty() ? scene.runs.front().y : scene.exact.back();
  chart.y.label = axis_label(named);
  chart.x.label =
      plane ? axis_label(scene.exact.empty() ? *scene.runs.front().x : scene.exact.front()) : "t [s]";
  if (!scene.runs.empty())
    chart.caption = fmt::format("Dashed: coarse runs with dt = {} s.", compact(scene.runs.front().dt, 3));
  if (!gone.empty()) chart.caption += fmt::format(" Where {} left the picture, the line ends.", gone);
  if (!scene.exact_is.empty()) chart.caption += " Exact: " + scene.exact_is + ".";
  return chart;
}

}  // namespace odemark
