// Where everything in a picture goes: decided once, before anything is drawn.
#include "reports/svg_layout.hpp"

#include <algorithm>
#include <cmath>

#include "reports/chart_notes.hpp"
#include "reports/svg_theme.hpp"
#include "reports/unicode.hpp"

namespace odemark {
namespace {

constexpr double edge = 14;
constexpr double line_height = 1.3;

double stack_height(const std::vector<std::string>& lines, double font_size) {
  return static_cast<double>(lines.size()) * font_size * line_height;
}

double widest(const std::vector<Tick>& ticks) {
  double width = 0;
  for (const Tick& tick : ticks)
    width = std::max(width, pixel_width(tick.label, theme::text_size, theme::exponent_size));
  return width;
}

std::vector<Tick> x_ticks_that_fit(const AxisView& view, double width) {
  for (int labels = 10; labels > 2; --labels) {
    std::vector<Tick> ticks = choose_ticks(view, labels, 26 / width);
    double previous = -1e9;
    bool fits = true;
    for (const Tick& tick : ticks) {
      if (tick.label.base.empty()) continue;
      const double half = pixel_width(tick.label, theme::text_size, theme::exponent_size) / 2;
      const double centre = view.fraction(tick.value) * width;
      fits = fits && centre - half >= previous + 8;
      previous = centre + half;
    }
    if (fits) return ticks;
  }
  return choose_ticks(view, 2, 26 / width);
}

std::vector<Tick> y_ticks_that_fit(const AxisView& view, double height) {
  return choose_ticks(view, static_cast<int>(height / 32), 40 / height);
}

bool has_diverged(const Chart& chart) {
  return std::any_of(chart.series.begin(), chart.series.end(), [](const Series& s) {
    return std::any_of(s.points.begin(), s.points.end(), [](const Point& p) { return p.diverged; });
  });
}

void make_units_equal(Layout& at, double available) {
  constexpr double tallest = 470;
  constexpr double lowest = 180;
  const double aspect = (at.y.high - at.y.low) / (at.x.high - at.x.low);
  at.plot_height = std::clamp(at.plot_width * aspect, lowest, tallest);
  at.plot_width = std::min(available, at.plot_height / aspect);
  at.left += (available - at.plot_width) / 2;
  // Only an extremely flat range still misses; it gains empty space above and below.
  const double span = (at.x.high - at.x.low) * at.plot_height / at.plot_width;
  const double middle = (at.y.high + at.y.low) / 2;
  at.y.low = middle - span / 2;
  at.y.high = middle + span / 2;
}

}  // namespace

Layout lay_out(const Chart& chart, const SvgOptions& options) {
  Layout at;
  const ChartViews views = fit_views(chart);
  at.x = views.x;
  at.y = views.y;
  at.width = theme::view_width;
  const double text_width = theme::view_width - 2 * edge;

  double cursor = edge;
  if (options.heading) {
    at.title = wrapped(chart.title, theme::title_size * 1.04, text_width);  // bold is wider
    at.caption = wrapped(chart.caption, theme::small_size, text_width);
    cursor += stack_height(at.title, theme::title_size) + stack_height(at.caption, theme::small_size) + 10;
  }
  at.top = cursor + (has_diverged(chart) ? 24 : 2);

  at.plot_height = theme::plot_height;
  at.y_label = wrapped(chart.y.label, theme::text_size, theme::plot_height);
  const double ticks_width = widest(y_ticks_that_fit(at.y, at.plot_height));
  at.left = edge + stack_height(at.y_label, theme::text_size) + ticks_width + 14;
  const double available = theme::view_width - at.left - edge - 10;
  at.plot_width = available;
  const bool linear = chart.x.scale == Scale::linear && chart.y.scale == Scale::linear;
  if (chart.equal_aspect && linear) make_units_equal(at, available);
  at.y_ticks = y_ticks_that_fit(at.y, at.plot_height);
  at.x_ticks = x_ticks_that_fit(at.x, at.plot_width);
  at.x_label = wrapped(chart.x.label, theme::text_size, at.plot_width);

  cursor = at.bottom() + 30 + stack_height(at.x_label, theme::text_size) + 8;
  const auto groups = options.legend == LegendPlace::none ? std::vector<LegendGroup>{} : legend_groups(chart);
  if (options.legend == LegendPlace::right && !groups.empty()) {
    at.legend = legend_columns(groups, 1, 1);
    at.legend_left = theme::view_width + 6;
    at.legend_top = at.top;
    at.width = at.legend_left + at.legend.width();
    cursor = std::max(cursor, at.legend_top + at.legend.height + 8);
  } else if (!groups.empty()) {
    at.legend = legend_columns(groups, text_width + 8, 4);
    at.legend_left = edge + 4;
    at.legend_top = cursor + 6;
    cursor = at.legend_top + at.legend.height + 8;
  }
  if (options.notes) {
    for (const std::string& note : chart_notes(chart)) {
      for (const std::string& line : wrapped(note, theme::small_size, text_width)) at.notes.push_back(line);
    }
  }
  at.notes_top = cursor;
  at.height = std::ceil(cursor + stack_height(at.notes, theme::small_size) + 6);
  at.width = std::ceil(at.width);
  return at;
}

}  // namespace odemark
