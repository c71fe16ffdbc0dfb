// Families of problems as tables and pages: what they are, what is certified, how stiff they are.
#pragma once

#include <string>
#include <vector>

#include "bench/data/problem_sheet.hpp"
#include "reports/html.hpp"
#include "reports/report_page.hpp"
#include "reports/table.hpp"

namespace odemark {

/// "62 families, 134 presets; closed form: 40 families; ..."
std::string counts_text(const std::vector<ProblemSheet>& sheets);
/// One line per preset: truth and digits, events, spectrum.
Table problems_overview_table(const std::vector<ProblemSheet>& sheets);

/// `problems.html`: the overview, with links.
Page families_page(const std::vector<ProblemSheet>& sheets);
/// `families/<id>.html`, one per sheet.
std::vector<NamedPage> family_pages(const std::vector<ProblemSheet>& sheets);

}  // namespace odemark
