// Where everything in a picture goes: decided once, before anything is drawn.
#pragma once

#include <string>
#include <vector>

#include "reports/axis.hpp"
#include "reports/chart.hpp"
#include "reports/legend.hpp"
#include "reports/svg.hpp"

namespace odemark {

struct Layout {
  double width = 0;  // of the whole view
  double height = 0;
  double left = 0;  // of the plot frame
  double top = 0;
  double plot_width = 0;
  double plot_height = 0;
  AxisView x{};
  AxisView y{};
  std::vector<Tick> x_ticks{};
  std::vector<Tick> y_ticks{};
  std::vector<std::string> title{};  // wrapped lines, likewise below
  std::vector<std::string> caption{};
  std::vector<std::string> x_label{};
  std::vector<std::string> y_label{};
  std::vector<std::string> notes{};
  LegendColumns legend{};
  double legend_left = 0;
  double legend_top = 0;
  double notes_top = 0;

  double right() const { return left + plot_width; }
  double bottom() const { return top + plot_height; }
  double px(double x_value) const { return left + x.fraction(x_value) * plot_width; }
  double py(double y_value) const { return bottom() - y.fraction(y_value) * plot_height; }
};

Layout lay_out(const Chart& chart, const SvgOptions& options);

}  // namespace odemark
