// Methods as tables and pages: facts of the coefficients, and the same measured, side by side.
#pragma once

#include <string>
#include <vector>

#include "bench/data/facts.hpp"
#include "reports/html.hpp"
#include "reports/report_page.hpp"
#include "reports/table.hpp"

namespace odemark {

/// One line per fact: value, and what it means or why there is none.
Table facts_table(const FactSheet& sheet);
/// Theory, measurement, difference and bound.
Table measured_table(const FactSheet& sheet);
/// One line per method: the facts that people choose by.
Table overview_table(const std::vector<FactSheet>& sheets);

/// `methods.html`: the overview, with links.
Page methods_page(const std::vector<FactSheet>& sheets);
/// `methods/<id>.html`, one per sheet.
std::vector<NamedPage> method_pages(const std::vector<FactSheet>& sheets);

}  // namespace odemark
