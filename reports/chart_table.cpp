// The data of a chart as a table: for readers who cannot see the picture, and for everyone who wants the
// numbers.
#include "reports/chart_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "reports/format.hpp"

namespace odemark {
namespace {

constexpr int digits = 6;

std::string or_else(const std::string& text, const char* otherwise) {
  return text.empty() ? otherwise : text;
}

Cell x_cell(double x) { return number_cell(x, compact(x, digits)); }

Cell y_cell(const Point& p) {
  Cell cell = p.diverged ? Cell{"diverged", Status::warn} : number_cell(p.y, compact(p.y, digits));
  if (!p.note.empty()) cell.text += fmt::format(" ({})", p.note);
  return cell;
}

using Lookup = std::map<double, const Point*>;

// Empty if a series visits an x twice (a closed curve) or has no proper x: such data need one row per point.
std::vector<Lookup> by_x(const Chart& chart) {
  std::vector<Lookup> lookups;
  for (const Series& series : chart.series) {
    Lookup& lookup = lookups.emplace_back();
    for (const Point& p : series.points) {
      if (std::isnan(p.x) || !lookup.emplace(p.x, &p).second) return {};
    }
  }
  return lookups;
}

bool fill_wide(Table& table, const Chart& chart) {
  const std::vector<Lookup> lookups = by_x(chart);
  std::map<double, int> xs;
  std::size_t points = 0;
  for (const Lookup& lookup : lookups) {
    points += lookup.size();
    for (const auto& entry : lookup) ++xs[entry.first];
  }
  if (lookups.empty() || xs.size() * lookups.size() > 2 * points) return false;  // mostly blank: not shared
  table.columns.push_back({or_else(chart.x.label, "x"), Align::right});
  for (const Series& series : chart.series) table.columns.push_back({series.label, Align::right});
  for (const auto& entry : xs) {
    std::vector<Cell> row{x_cell(entry.first)};
    for (const Lookup& lookup : lookups) {
      const auto found = lookup.find(entry.first);
      row.push_back(found == lookup.end() ? Cell{} : y_cell(*found->second));
    }
    table.rows.push_back(std::move(row));
  }
  return true;
}

void fill_long(Table& table, const Chart& chart) {
  table.columns = {
      {"series"}, {or_else(chart.x.label, "x"), Align::right}, {or_else(chart.y.label, "y"), Align::right}};
  for (const Region& region : chart.regions) {
    std::map<int, AxisRange> extent;  // 0: x, 1: y
    const auto widen = [&extent](int axis, double value) {
      AxisRange& range = extent.try_emplace(axis, AxisRange{value, value}).first->second;
      range = {std::min(range.low, value), std::max(range.high, value)};
    };
    for (const auto& outline : region.outlines) {
      for (const Position& p : outline) {
        if (std::isfinite(p.x)) widen(0, p.x);
        if (std::isfinite(p.y)) widen(1, p.y);
      }
    }
    std::vector<Cell> row{{region.label}};
    for (const int axis : {0, 1}) {
      const auto found = extent.find(axis);
      row.push_back(found == extent.end() ? number_cell(std::nan(""), "")
                                          : Cell{fmt::format("{} … {}", compact(found->second.low, 4),
                                                             compact(found->second.high, 4))});
    }
    table.rows.push_back(std::move(row));
  }
  for (const Series& series : chart.series) {
    for (const Point& p : series.points) table.rows.push_back({{series.label}, x_cell(p.x), y_cell(p)});
  }
}

}  // namespace

Table chart_table(const Chart& chart) {
  Table table;
  table.note = or_else(chart.y.label, "y");
  if (chart.regions.empty() && fill_wide(table, chart)) {
    table.note = "Cells: " + table.note + '.';
  } else {
    fill_long(table, chart);
    table.note = chart.regions.empty() ? "" : "Of a region: its extent.";
  }
  return table;
}

}  // namespace odemark
