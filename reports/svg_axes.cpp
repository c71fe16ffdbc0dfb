// Everything around the data: heading, grid, frame, ticks, axis labels, notes.
#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "reports/markup.hpp"
#include "reports/svg_parts.hpp"
#include "reports/svg_theme.hpp"
#include "reports/unicode.hpp"

namespace odemark::svg {
namespace {

constexpr double line_height = 1.3;

void segment(std::string& path, double x1, double y1, double x2, double y2) {
  fmt::format_to(std::back_inserter(path), "M{},{}L{},{}", coordinate(x1), coordinate(y1), coordinate(x2),
                 coordinate(y2));
}

void stroke_path(std::string& out, std::string_view path, std::string_view role, std::string_view colour,
                 std::string_view width) {
  if (path.empty()) return;
  fmt::format_to(std::back_inserter(out),
                 "<path class=\"{}\" d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"{}\"/>\n", role,
                 path, colour, width);
}

bool is_inner_zero(const AxisView& view, double value) { return view.scale == Scale::linear && value == 0; }

void tick_label(std::string& out, double x, double y, const TickLabel& label, std::string_view anchor) {
  fmt::format_to(std::back_inserter(out), "<text class=\"muted\" x=\"{}\" y=\"{}\" text-anchor=\"{}\">{}",
                 coordinate(x), coordinate(y), anchor, escaped(label.base));
  if (!label.exponent.empty())
    fmt::format_to(std::back_inserter(out), "<tspan dy=\"-6\" font-size=\"{}\">{}</tspan>",
                   theme::exponent_size, escaped(label.exponent));
  out += "</text>\n";
}

double lines_of_text(std::string& out, double x, double y, const std::vector<std::string>& lines,
                     const TextStyle& style) {
  for (const std::string& line : lines) {
    y += style.size * line_height;
    text(out, x, y, line, style);
  }
  return y;
}

}  // namespace

void text(std::string& out, double x, double y, std::string_view content, const TextStyle& style) {
  constexpr const char* anchors[] = {"start", "middle", "end"};
  const std::string at_x = coordinate(x);
  const std::string at_y = coordinate(y);
  fmt::format_to(std::back_inserter(out),
                 "<text class=\"{}{}\" x=\"{}\" y=\"{}\" font-size=\"{}\" fill=\"{}\"", style.role,
                 style.halo ? " halo" : "", at_x, at_y, style.size,
                 style.role == "ink" ? theme::ink : theme::muted);
  if (style.anchor != Anchor::start)
    fmt::format_to(std::back_inserter(out), " text-anchor=\"{}\"", anchors[static_cast<int>(style.anchor)]);
  if (style.bold) out += " font-weight=\"600\"";
  if (style.halo)
    fmt::format_to(std::back_inserter(out),
                   " stroke=\"{}\" stroke-width=\"4\" stroke-linejoin=\"round\" paint-order=\"stroke\"",
                   theme::paper);
  if (style.upward) fmt::format_to(std::back_inserter(out), " transform=\"rotate(-90 {} {})\"", at_x, at_y);
  fmt::format_to(std::back_inserter(out), ">{}</text>\n", escaped(content));
}

void draw_heading(std::string& out, const Layout& at) {
  constexpr double edge = 14;
  double y = 8;
  y = lines_of_text(out, edge, y, at.title, {.size = theme::title_size, .bold = true});
  lines_of_text(out, edge, y + 3, at.caption, {.size = theme::small_size, .role = "muted"});
}

void draw_grid(std::string& out, const Layout& at) {
  std::string grid;
  std::string zero;
  for (const Tick& tick : at.x_ticks) {
    if (!tick.grid || !at.x.shows(tick.value)) continue;
    segment(is_inner_zero(at.x, tick.value) ? zero : grid, at.px(tick.value), at.top, at.px(tick.value),
            at.bottom());
  }
  for (const Tick& tick : at.y_ticks) {
    if (!tick.grid || !at.y.shows(tick.value)) continue;
    segment(is_inner_zero(at.y, tick.value) ? zero : grid, at.left, at.py(tick.value), at.right(),
            at.py(tick.value));
  }
  stroke_path(out, grid, "grid", theme::grid, "1");
  stroke_path(out, zero, "zero", theme::zero, "1.3");
}

void draw_frame(std::string& out, const Chart&, const Layout& at) {
  std::string marks;
  for (const Tick& tick : at.x_ticks) {
    if (at.x.shows(tick.value))
      segment(marks, at.px(tick.value), at.bottom(), at.px(tick.value), at.bottom() + (tick.grid ? 6 : 3));
  }
  for (const Tick& tick : at.y_ticks) {
    if (at.y.shows(tick.value))
      segment(marks, at.left - (tick.grid ? 6 : 3), at.py(tick.value), at.left, at.py(tick.value));
  }
  fmt::format_to(std::back_inserter(marks), "M{},{}h{}v{}h-{}Z", coordinate(at.left), coordinate(at.top),
                 coordinate(at.plot_width), coordinate(at.plot_height), coordinate(at.plot_width));
  stroke_path(out, marks, "axis", theme::axis, "1");

  fmt::format_to(std::back_inserter(out), "<g font-size=\"{}\" fill=\"{}\">\n", theme::text_size,
                 theme::muted);
  double ticks_width = 0;
  for (const Tick& tick : at.x_ticks) {
    if (!tick.label.base.empty() && at.x.shows(tick.value))
      tick_label(out, at.px(tick.value), at.bottom() + 24, tick.label, "middle");
  }
  for (const Tick& tick : at.y_ticks) {
    if (tick.label.base.empty() || !at.y.shows(tick.value)) continue;
    tick_label(out, at.left - 10, at.py(tick.value) + 5.5, tick.label, "end");
    ticks_width = std::max(ticks_width, pixel_width(tick.label, theme::text_size, theme::exponent_size));
  }
  out += "</g>\n";

  lines_of_text(out, at.left + at.plot_width / 2, at.bottom() + 28, at.x_label,
                {.size = theme::text_size, .anchor = Anchor::middle});
  const double step = theme::text_size * line_height;
  double x = at.left - ticks_width - 16 - step * static_cast<double>(at.y_label.size() - 1);
  for (const std::string& line : at.y_label) {
    text(out, x, at.top + at.plot_height / 2, line,
         {.size = theme::text_size, .anchor = Anchor::middle, .upward = true});
    x += step;
  }
}

void draw_notes(std::string& out, const Layout& at) {
  constexpr double edge = 14;
  lines_of_text(out, edge, at.notes_top - 4, at.notes, {.size = theme::small_size, .role = "muted"});
}

}  // namespace odemark::svg
