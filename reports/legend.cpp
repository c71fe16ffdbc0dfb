// What a legend lists, grouped by family, and how its entries fall into columns.
#include "reports/legend.hpp"

#include <algorithm>
#include <numeric>

#include "reports/svg_theme.hpp"
#include "reports/unicode.hpp"

namespace odemark {
namespace {

std::size_t rows_of(const LegendGroup& group) {
  return group.entries.size() + (group.family.empty() ? 0 : 1);
}

std::vector<std::vector<LegendGroup>> stacked(const std::vector<LegendGroup>& groups, std::size_t rows) {
  std::vector<std::vector<LegendGroup>> columns;
  std::size_t used = 0;
  for (const LegendGroup& group : groups) {
    if (columns.empty() || used + rows_of(group) > rows) {
      columns.emplace_back();
      used = 0;
    }
    columns.back().push_back(group);
    used += rows_of(group);
  }
  return columns;
}

double height_of(const std::vector<LegendGroup>& column) {
  double height = 0;
  for (const LegendGroup& group : column) {
    if (height > 0 && !group.family.empty()) height += legend_group_gap;
    height += legend_row * static_cast<double>(rows_of(group));
  }
  return height;
}

double width_of(const std::vector<LegendGroup>& column) {
  constexpr double gap = 16;
  double width = 0;
  for (const LegendGroup& group : column) {
    width = std::max(width, pixel_width(group.family, 1.2 * theme::small_size) + gap);  // bold is wider
    for (const LegendEntry& entry : group.entries)
      width = std::max(width, swatch_width + 6 + pixel_width(entry.label, theme::small_size) + gap);
  }
  return width;
}

}  // namespace

std::vector<LegendGroup> legend_groups(const Chart& chart) {
  std::vector<LegendGroup> groups;
  const auto add = [&groups](const std::string& family, LegendEntry entry) {
    auto found =
        std::find_if(groups.begin(), groups.end(), [&](const auto& g) { return g.family == family; });
    if (found == groups.end()) found = groups.insert(groups.end(), LegendGroup{family, {}});
    found->entries.push_back(std::move(entry));
  };
  for (const Region& r : chart.regions) add(r.family, {r.id, r.label, r.style, true});
  for (const Series& s : chart.series) add(s.family, {s.id, s.label, s.style, false});
  const bool telling = groups.size() > 1 && std::any_of(groups.begin(), groups.end(),
                                                        [](const auto& g) { return g.entries.size() > 1; });
  if (telling) return groups;
  std::vector<LegendGroup> flat;  // one entry each, so that columns may break anywhere
  for (const LegendGroup& group : groups) {
    for (const LegendEntry& entry : group.entries) flat.push_back({"", {entry}});
  }
  return flat;
}

double LegendColumns::width() const { return std::accumulate(widths.begin(), widths.end(), 0.0); }

LegendColumns legend_columns(const std::vector<LegendGroup>& groups, double width, int most_columns) {
  std::size_t total = 0;
  std::size_t rows = 1;
  for (const LegendGroup& group : groups) {
    total += rows_of(group);
    rows = std::max(rows, rows_of(group));
  }
  LegendColumns legend;
  // The flattest arrangement that fits; a single column is taken as it is.
  for (; rows <= total; ++rows) {
    legend.columns = stacked(groups, rows);
    legend.widths.clear();
    for (const auto& column : legend.columns) legend.widths.push_back(width_of(column));
    const auto most = static_cast<std::size_t>(std::max(most_columns, 1));
    if (legend.columns.size() <= most && legend.width() <= width) break;
  }
  for (const auto& column : legend.columns) legend.height = std::max(legend.height, height_of(column));
  return legend;
}

}  // namespace odemark
