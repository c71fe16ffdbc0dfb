// Sentences about what a picture cannot show: no point disappears without a word.
#pragma once

#include <string>
#include <vector>

#include "reports/axis.hpp"
#include "reports/chart.hpp"

namespace odemark {

struct ChartViews {
  AxisView x;
  AxisView y;
};

// Axes fitted to everything drawn: points, regions, and the finite ends of lines and bands.
ChartViews fit_views(const Chart& chart);

std::vector<std::string> chart_notes(const Chart& chart);

}  // namespace odemark
