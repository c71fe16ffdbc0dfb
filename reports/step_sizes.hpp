// The steps that codes choose over time.
#pragma once

#include <string>
#include <vector>

#include "bench/data/row.hpp"
#include "reports/chart.hpp"
#include "reports/palette.hpp"

namespace odemark {

/// log h over t of the codes a reader knows, at the tolerance 1e-6 or the nearest that was run. No series
/// where no row of the problem keeps its steps. `unit` is that of the problem's time, if it has one.
Chart step_size_chart(const std::vector<Row>& rows, const std::string& problem, const Palette& palette,
                      const std::string& unit = "");

}  // namespace odemark
