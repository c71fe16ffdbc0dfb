// Stability: limits measured and in theory, regions of the coefficients, what a step leaves of a mode.
#pragma once

#include <string>
#include <vector>

#include "bench/data/pictures.hpp"
#include "bench/data/stability.hpp"
#include "reports/chart.hpp"
#include "reports/html.hpp"
#include "reports/palette.hpp"
#include "reports/table.hpp"

namespace odemark {

struct StabilityCounts {
  int agrees = 0, differs = 0, blank = 0;  // blank: nothing was measured, or there is no theory
};
StabilityCounts count_stability(const std::vector<StabilityRow>& rows);

/// Methods down, problems across: the largest stable dt.
Table limit_matrix(const std::vector<StabilityRow>& rows);
/// One problem: measured, theory, difference, verdict, growth.
Table limit_table(const std::vector<StabilityRow>& rows, const std::string& problem);
/// Rows whose measurement and theory do not agree.
Table disagreeing_limits(const std::vector<StabilityRow>& rows);
Table damping_table(const Pictures& pictures);

/// The regions |R(z)| <= 1 of a few methods each, with the eigenvalues of the problems times their suggested
/// dt.
std::vector<Chart> region_charts(const Pictures& pictures, const std::vector<StabilityRow>& rows,
                                 const Palette& palette);

Section stability_section(const std::vector<StabilityRow>& rows, const Pictures& pictures,
                          const Palette& palette);

}  // namespace odemark
