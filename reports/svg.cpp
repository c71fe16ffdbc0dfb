// A chart as one self-contained SVG: assembles the parts.
#include "reports/svg.hpp"

#include <fmt/format.h>

#include <iterator>
#include <set>

#include "reports/markup.hpp"
#include "reports/palette.hpp"
#include "reports/svg_layout.hpp"
#include "reports/svg_parts.hpp"
#include "reports/svg_theme.hpp"

namespace odemark {
namespace {

// Only overrides: a viewer that blocks all style shows the complete light picture.
std::string dark_style(const Chart& chart, std::string_view prefix) {
  std::set<int> colours;
  const int count = theme_colour_count();
  for (const Series& s : chart.series) colours.insert(((s.style.colour % count) + count) % count);
  for (const Region& r : chart.regions) colours.insert(((r.style.colour % count) + count) % count);
  std::string css = "<style>@media screen and (prefers-color-scheme:dark){";
  const auto rule = [&](std::string_view role, std::string_view property, std::string_view colour) {
    fmt::format_to(std::back_inserter(css), "#{} .{}{{{}:{}}}", prefix, role, property, colour);
  };
  rule("paper", "fill", theme::dark_paper);
  rule("ink", "fill", theme::dark_ink);
  rule("muted", "fill", theme::dark_muted);
  rule("halo", "stroke", theme::dark_paper);
  rule("grid", "stroke", theme::dark_grid);
  rule("axis", "stroke", theme::dark_axis);
  rule("zero", "stroke", theme::dark_zero);
  rule("guide", "stroke", theme::dark_muted);
  rule("band", "fill", theme::dark_band);
  for (const int c : colours) rule("c" + std::to_string(c), "color", theme_colour(c).dark);
  return css + "}</style>\n";
}

void define_shapes(std::string& out, const Chart& chart, const Layout& at, std::string_view prefix) {
  fmt::format_to(std::back_inserter(out),
                 "<defs><clipPath id=\"{0}-clip\"><rect x=\"{1}\" y=\"{2}\" width=\"{3}\" "
                 "height=\"{4}\"/></clipPath>",
                 prefix, coordinate(at.left), coordinate(at.top), coordinate(at.plot_width),
                 coordinate(at.plot_height));
  std::set<Marker> markers;
  for (const Series& s : chart.series) markers.insert(s.style.marker);
  for (const Marker m : markers)
    fmt::format_to(std::back_inserter(out), "<path id=\"{}-m{}\" d=\"{}\"/>", prefix, static_cast<int>(m),
                   svg::marker_path(m));
  out += "</defs>\n";
}

}  // namespace

std::string to_svg(const Chart& chart, std::string_view id_prefix, const SvgOptions& options) {
  const std::string prefix = safe_id(id_prefix);
  const Layout at = lay_out(chart, options);
  std::string out = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" id=\"{0}\" viewBox=\"0 0 {1:.0f} {2:.0f}\" "
      "width=\"{1:.0f}\" "
      "height=\"{2:.0f}\" role=\"img\" aria-labelledby=\"{0}-title {0}-desc\" font-family=\"{3}\">\n"
      "<title id=\"{0}-title\">{4}</title>\n<desc id=\"{0}-desc\">{5}</desc>\n",
      prefix, at.width, at.height, theme::font, escaped(chart.title), escaped(chart.caption));
  out += dark_style(chart, prefix);
  define_shapes(out, chart, at, prefix);
  fmt::format_to(std::back_inserter(out),
                 "<rect class=\"paper\" width=\"{:.0f}\" height=\"{:.0f}\" fill=\"{}\"/>\n", at.width,
                 at.height, theme::paper);
  svg::draw_heading(out, at);
  svg::draw_bands(out, chart, at);
  svg::draw_grid(out, at);
  svg::draw_regions(out, chart, at, prefix);
  svg::draw_slope_fan(out, chart, at);
  svg::draw_frame(out, chart, at);
  svg::draw_series(out, chart, at, prefix);
  svg::draw_labels(out, chart, at);
  svg::draw_legend(out, at);
  svg::draw_notes(out, at);
  return out + "</svg>\n";
}

}  // namespace odemark
