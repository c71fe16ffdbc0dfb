// A chart as an HTML figure: picture, legend in page text, caption, notes, folded data table.
#include "reports/html_figure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "reports/chart_notes.hpp"
#include "reports/chart_table.hpp"
#include "reports/decimate.hpp"
#include "reports/legend.hpp"
#include "reports/markup.hpp"
#include "reports/svg.hpp"
#include "reports/svg_parts.hpp"
#include "reports/table.hpp"

namespace odemark {
namespace {

/// Long names may break after their underscores, and nowhere else.
std::string breakable(const std::string& label) {
  std::string out;
  for (const char c : escaped(label)) {
    out += c;
    if (c == '_') out += "<wbr>";
  }
  return out;
}

// In page text rather than in the picture: it reflows beside or below and never shrinks with the picture.
std::string legend_html(const Chart& chart) {
  const auto groups = legend_groups(chart);
  if (groups.empty()) return {};
  std::size_t entries = 0;
  for (const LegendGroup& group : groups) entries += group.entries.size();
  constexpr std::size_t beside = 18;  // more would stand taller than the picture and go below it
  std::string out = entries > beside ? "<ul class=\"legend many\">\n" : "<ul class=\"legend\">\n";
  for (const LegendGroup& group : groups) {
    if (!group.family.empty())
      fmt::format_to(std::back_inserter(out), "<li class=\"family\"><b>{}</b><ul>\n", escaped(group.family));
    for (const LegendEntry& entry : group.entries) {
      fmt::format_to(std::back_inserter(out),
                     "<li data-series=\"{}\"><svg width=\"32\" height=\"16\" viewBox=\"0 -8 32 16\" "
                     "aria-hidden=\"true\">",
                     escaped(entry.id));
      svg::swatch(out, entry.style, entry.is_region, 0, 0);
      fmt::format_to(std::back_inserter(out), "</svg><span>{}</span></li>\n", breakable(entry.label));
    }
    if (!group.family.empty()) out += "</ul></li>\n";
  }
  return out + "</ul>\n";
}

std::string decimation_note(const Chart& chart) {
  std::size_t most_points = 0;
  for (const Series& series : chart.series) most_points = std::max(most_points, series.points.size());
  if (most_points <= points_per_series) return {};
  return fmt::format("Drawn with at most {} of up to {} points per series; all extremes are kept.",
                     points_per_series, most_points);
}

}  // namespace

std::string figure_html(const Chart& chart, std::string_view name) {
  const Chart drawn = decimated(chart);
  const std::string id = safe_id(name);
  const std::string svg =
      to_svg(drawn, id + "-svg", {.heading = false, .legend = LegendPlace::none, .notes = false});
  // The div with data-chart is where a script may put an interactive chart of the same model.
  std::string out = fmt::format(
      "<figure id=\"{0}\">\n<h3><a class=\"anchor\" href=\"#{0}\">{1}</a></h3>\n<div class=\"chart\">\n"
      "<div class=\"plot\" id=\"{0}-plot\" data-chart=\"{2}\">\n{3}</div>\n{4}</div>\n",
      id, escaped(chart.title), escaped(chart.id), svg, legend_html(chart));
  out += "<figcaption>";
  if (!chart.caption.empty()) fmt::format_to(std::back_inserter(out), "<p>{}</p>", escaped(chart.caption));
  std::vector<std::string> notes = chart_notes(chart);
  if (std::string note = decimation_note(chart); !note.empty()) notes.push_back(std::move(note));
  for (const std::string& note : notes)
    fmt::format_to(std::back_inserter(out), "<p class=\"muted\">{}</p>", escaped(note));
  out += "</figcaption>\n";
  Table data = chart_table(drawn);
  data.title = "Data: " + chart.title;
  fmt::format_to(std::back_inserter(out), "<details><summary>Data table</summary>\n{}</details>\n</figure>\n",
                 to_html(data));
  return out;
}

}  // namespace odemark
