// The legend inside a picture: swatches and labels in columns, families as small headings.
#include <fmt/format.h>

#include <iterator>

#include "reports/svg_parts.hpp"
#include "reports/svg_theme.hpp"

namespace odemark::svg {

void draw_legend(std::string& out, const Layout& at) {
  double x = at.legend_left;
  for (std::size_t c = 0; c < at.legend.columns.size(); ++c) {
    double y = at.legend_top;
    for (const LegendGroup& group : at.legend.columns[c]) {
      if (!group.family.empty()) {
        if (y > at.legend_top) y += legend_group_gap;
        text(out, x, y + 14, group.family, {.size = theme::small_size, .role = "muted", .bold = true});
        y += legend_row;
      }
      for (const LegendEntry& entry : group.entries) {
        swatch(out, entry.style, entry.is_region, x, y + legend_row / 2 - 2);
        text(out, x + swatch_width + 6, y + 14, entry.label, {.size = theme::small_size});
        y += legend_row;
      }
    }
    x += at.legend.widths[c];
  }
}

}  // namespace odemark::svg
