// A chart as an HTML figure: picture, legend in page text, caption, notes, folded data table.
#pragma once

#include <string>
#include <string_view>

#include "reports/chart.hpp"

namespace odemark {

// `name` must be unique in the page: it is the figure's anchor and the prefix of all ids inside.
std::string figure_html(const Chart& chart, std::string_view name);

}  // namespace odemark
