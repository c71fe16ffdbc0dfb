// A chart as one self-contained SVG: deterministic bytes, light theme in attributes, dark theme as an
// override.
#pragma once

#include <string>
#include <string_view>

#include "reports/chart.hpp"

namespace odemark {

enum class LegendPlace { below, right, none };

struct SvgOptions {
  bool heading = true;  // title and caption inside the picture; a page that prints its own switches them off
  LegendPlace legend = LegendPlace::below;  // below stays readable at 420 px; right suits wide papers
  bool notes = true;                        // what could not be drawn, in words, at the bottom
};

// id_prefix must differ between pictures of one page; every id inside starts with it.
std::string to_svg(const Chart& chart, std::string_view id_prefix, const SvgOptions& options = {});

}  // namespace odemark
