// The parts of an SVG picture; each appends its elements. Internal to the emitter and the page's legend.
#pragma once

#include <string>
#include <string_view>

#include "reports/chart.hpp"
#include "reports/svg_layout.hpp"

namespace odemark::svg {

struct TextStyle {
  double size;
  Anchor anchor = Anchor::start;
  std::string_view role = "ink";  // ink or muted
  bool bold = false;
  bool halo = false;  // an outline in the paper colour keeps labels legible on top of lines
  bool upward = false;
};

void text(std::string& out, double x, double y, std::string_view content, const TextStyle& style);

// class and colour of a series group; everything inside paints with currentColor.
std::string colour_attributes(const Style& style);
std::string stroke_attributes(const Style& style, double width);
std::string_view marker_path(Marker marker);

// The picture of a style in a legend, its left end at (x, y).
void swatch(std::string& out, const Style& style, bool is_region, double x, double y);

void draw_heading(std::string& out, const Layout& at);
void draw_grid(std::string& out, const Layout& at);
void draw_frame(std::string& out, const Chart& chart, const Layout& at);
void draw_bands(std::string& out, const Chart& chart, const Layout& at);
void draw_regions(std::string& out, const Chart& chart, const Layout& at, std::string_view prefix);
void draw_series(std::string& out, const Chart& chart, const Layout& at, std::string_view prefix);
void draw_slope_fan(std::string& out, const Chart& chart, const Layout& at);
void draw_labels(std::string& out, const Chart& chart, const Layout& at);
void draw_legend(std::string& out, const Layout& at);
void draw_notes(std::string& out, const Layout& at);

}  // namespace odemark::svg
