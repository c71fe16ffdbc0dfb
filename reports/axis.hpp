// Axis arithmetic: fitting a range to data, mapping values to the frame, choosing ticks.
#pragma once

#include <string>
#include <vector>

#include "reports/chart.hpp"

namespace odemark {

// The visible stretch of an axis. On a log axis low and high are decimal exponents.
struct AxisView {
  Scale scale = Scale::linear;
  double low = 0;
  double high = 1;

  bool can_place(double value) const;   // finite, and positive on a log axis
  double fraction(double value) const;  // 0 at low, 1 at high; only for values that can be placed
  bool shows(double value) const;       // placed inside the frame
};

// The range asked for, else the data with a small margin. Empty data and equal values give a sensible range
// too.
AxisView fit_axis(const Axis& axis, const std::vector<double>& values);

// "10" with exponent "−8", or plain "0.5"; the exponent is raised by the emitter.
struct TickLabel {
  std::string base;
  std::string exponent{};
};

double pixel_width(const TickLabel& label, double font_size, double exponent_size);

struct Tick {
  double value;
  TickLabel label{};  // empty base: no label
  bool grid = true;   // false: a minor tick, drawn short
};

// At most about `labels` labelled ticks; minor ticks on a log axis when a decade is at least `roomy` of the
// axis.
std::vector<Tick> choose_ticks(const AxisView& view, int labels, double roomy = 0.05);

}  // namespace odemark
