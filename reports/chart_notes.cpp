// Sentences about what a picture cannot show: no point disappears without a word.
#include "reports/chart_notes.hpp"

#include <fmt/format.h>

#include <cmath>

namespace odemark {
namespace {

// Counts one kind of loss and remembers in which series, so that the note says where to look.
struct Loss {
  int points = 0;
  std::vector<std::string> series{};

  void add(const std::string& label) {
    ++points;
    if (series.empty() || series.back() != label) series.push_back(label);
  }

  void report(std::vector<std::string>& notes, const char* reason) const {
    if (points == 0) return;
    std::string where;
    constexpr std::size_t named = 4;
    for (std::size_t i = 0; i < series.size() && i < named; ++i) where += (i > 0 ? ", " : "") + series[i];
    if (series.size() > named) where += fmt::format(" and {} more", series.size() - named);
    notes.push_back(fmt::format("{} {} {}: {}", points, points == 1 ? "point" : "points", reason, where));
  }
};

}  // namespace

ChartViews fit_views(const Chart& chart) {
  std::vector<double> xs;
  std::vector<double> ys;
  for (const Series& series : chart.series) {
    for (const Point& point : series.points) {
      const bool other_is_good =
          point.diverged || (std::isfinite(point.y) && (chart.y.scale == Scale::linear || point.y > 0));
      if (other_is_good) xs.push_back(point.x);
      if (!point.diverged && std::isfinite(point.x)) ys.push_back(point.y);
    }
  }
  for (const Region& region : chart.regions) {
    for (const auto& outline : region.outlines) {
      for (const Position& position : outline) {
        xs.push_back(position.x);
        ys.push_back(position.y);
      }
    }
  }
  for (const ReferenceLine& line : chart.lines)
    (line.direction == Direction::horizontal ? ys : xs).push_back(line.value);
  for (const Band& band : chart.bands) {
    auto& values = band.direction == Direction::horizontal ? ys : xs;
    values.push_back(band.low);  // infinite ends are ignored by fit_axis
    values.push_back(band.high);
    const Axis& axis = band.direction == Direction::horizontal ? chart.y : chart.x;
    // An open floor on a log axis keeps most of a decade in view, else it would be a hairline.
    if (axis.scale == Scale::log10 && !(band.low > 0)) values.push_back(band.high / 8);
  }
  return {fit_axis(chart.x, xs), fit_axis(chart.y, ys)};
}

std::vector<std::string> chart_notes(const Chart& chart) {
  const ChartViews views = fit_views(chart);
  Loss diverged;
  Loss not_finite;
  Loss not_positive;
  Loss outside;
  for (const Series& series : chart.series) {
    for (const Point& p : series.points) {
      const bool finite = std::isfinite(p.x) && (p.diverged || std::isfinite(p.y));
      const bool placed = views.x.can_place(p.x) && (p.diverged || views.y.can_place(p.y));
      if (!finite) {
        not_finite.add(series.label);
      } else if (!placed) {
        not_positive.add(series.label);
      } else if (!views.x.shows(p.x) || (!p.diverged && !views.y.shows(p.y))) {
        outside.add(series.label);
      } else if (p.diverged) {
        diverged.add(series.label);
      }
    }
  }
  std::vector<std::string> notes;
  diverged.report(notes, "diverged, hollow on the top frame");
  not_finite.report(notes, "not finite, not drawn");
  not_positive.report(notes, "zero or negative, not drawable on a log axis");
  outside.report(notes, "outside the frame");
  return notes;
}

}  // namespace odemark
