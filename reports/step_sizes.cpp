#include "reports/step_sizes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "reports/format.hpp"
#include "reports/work_curves.hpp"

namespace odemark {
namespace {

/// A few of every way of choosing steps: more would hide each other.
constexpr std::string_view shown[] = {"dormand_prince54", "verner87", "rodas5p",
                                      "radau_iia5",       "bdf",      "cvode_bdf"};
constexpr double wished = 1e-6;

double distance(const Row& row) { return std::abs(std::log(*row.rtol / wished)); }

}  // namespace

Chart step_size_chart(const std::vector<Row>& rows, const std::string& problem, const Palette& palette,
                      const std::string& unit) {
  Chart chart{
      .id = problem + "-step-sizes", .title = problem + ": the steps that codes choose", .caption = ""};
  const std::string in = unit.empty() ? "" : fmt::format(" [{}]", unit);
  chart.x = {.label = "t" + in};
  chart.y = {.label = "h" + in, .scale = Scale::log10};
  double nearest = std::numeric_limits<double>::infinity(), tolerance = 0;
  for (const Row& row : rows)
    if (row.problem == problem && row.rtol && row.history && distance(row) < nearest)
      nearest = distance(row), tolerance = *row.rtol;
  for (const auto id : shown) {
    const auto row = std::find_if(rows.begin(), rows.end(), [&](const Row& r) {
      return r.problem == problem && r.method == id && r.rtol == tolerance && r.history &&
             r.status == "reached_end";
    });
    if (row == rows.end()) continue;
    Series series{row->method, row->method, row->kind, {}, palette.style_of(row->method)};
    series.style.marker = Marker::none;
    const RowSteps& steps = *row->history;
    for (std::size_t i = 0; i < steps.time.size(); ++i)
      series.points.push_back({rounded(steps.time[i]), rounded(steps.step[i])});
    chart.series.push_back(std::move(series));
  }
  chart.caption = fmt::format(
      "Accepted steps at tolerance {}, at most 64 of each run, evenly taken. Who steps over what is slow and "
      "shortens the step where the solution turns is doing what error control is for.",
      compact(tolerance, 2));
  return chart;
}

}  // namespace odemark
