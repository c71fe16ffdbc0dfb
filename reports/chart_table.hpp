// The data of a chart as a table: for readers who cannot see the picture, and for everyone who wants the
// numbers.
#pragma once

#include "reports/chart.hpp"
#include "reports/table.hpp"

namespace odemark {

// One row per x and one column per series where the series share their x values, else one row per point.
Table chart_table(const Chart& chart);

}  // namespace odemark
