// What a legend lists, grouped by family, and how its entries fall into columns.
#pragma once

#include <string>
#include <vector>

#include "reports/chart.hpp"

namespace odemark {

struct LegendEntry {
  std::string id;
  std::string label;
  Style style{};
  bool is_region = false;
};

struct LegendGroup {
  std::string family;  // empty: no heading
  std::vector<LegendEntry> entries;
};

// In order of first appearance. Headings only where they say something: some family has two members or more.
std::vector<LegendGroup> legend_groups(const Chart& chart);

struct LegendColumns {
  std::vector<std::vector<LegendGroup>> columns{};  // a group is never split
  std::vector<double> widths{};
  double height = 0;

  double width() const;
};

inline constexpr double legend_row = 22;
inline constexpr double legend_group_gap = 6;
inline constexpr double swatch_width = 34;

LegendColumns legend_columns(const std::vector<LegendGroup>& groups, double width, int most_columns);

}  // namespace odemark
