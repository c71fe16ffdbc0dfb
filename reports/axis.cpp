// Axis arithmetic: fitting a range to data, mapping values to the frame, choosing ticks.
#include "reports/axis.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "reports/unicode.hpp"

namespace odemark {
namespace {

constexpr double largest = 1e300;  // sums and differences of bounds must stay finite

double to_axis(Scale scale, double value) {
  return scale == Scale::log10 ? std::log10(value) : std::clamp(value, -largest, largest);
}

std::string with_minus(std::string number) {
  if (!number.empty() && number.front() == '-') number.replace(0, 1, "−");
  return number;
}

TickLabel power_label(long mantissa, int exponent) {
  if (mantissa == 1) return {"10", with_minus(std::to_string(exponent))};
  return {with_minus(std::to_string(mantissa)) + "×10", with_minus(std::to_string(exponent))};
}

// Labels need as many decimals as the step, whatever the size of the values.
TickLabel linear_label(double value, double step, double greatest) {
  if (std::abs(value) < step / 2) return {"0"};
  const int step_exponent = static_cast<int>(std::floor(std::log10(step) + 1e-9));
  if (greatest < 1e5 && greatest >= 1e-3)
    return {with_minus(fmt::format("{:.{}f}", value, std::clamp(-step_exponent, 0, 15)))};
  const int exponent = static_cast<int>(std::floor(std::log10(greatest)));
  const double mantissa = value / std::pow(10.0, exponent);
  return {with_minus(fmt::format("{:.{}f}×10", mantissa, std::clamp(exponent - step_exponent, 0, 15))),
          with_minus(std::to_string(exponent))};
}

double nice_step(double span, int steps) {
  const double raw = span / std::max(steps, 1);
  const double power = std::pow(10.0, std::floor(std::log10(raw)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= raw * (1 - 1e-9)) return factor * power;
  }
  return 10 * power;
}

std::vector<Tick> linear_ticks(double low, double high, int labels) {
  std::vector<Tick> ticks;
  const double step = nice_step(high - low, labels);
  const double greatest = std::max(std::abs(low), std::abs(high));
  const double tolerance = step * 1e-6;
  for (double i = std::ceil((low - tolerance) / step); i * step <= high + tolerance; ++i) {
    ticks.push_back({i * step, linear_label(i * step, step, greatest)});
    if (ticks.size() > 100) break;  // the step no longer resolves next to so large a value
  }
  return ticks;
}

// Less than two decades: 1, 2, 5 of each; if even those are too few, evenly spaced values on the log scale.
std::vector<Tick> short_log_ticks(const AxisView& view, int labels) {
  std::vector<Tick> ticks;
  for (int k = static_cast<int>(std::floor(view.low)); k <= static_cast<int>(std::floor(view.high)); ++k) {
    for (const long mantissa : {1L, 2L, 5L}) {
      const double value = static_cast<double>(mantissa) * std::pow(10.0, k);
      const bool plain = k >= -2 && k <= 3;
      if (!view.shows(value)) continue;
      ticks.push_back({value, plain ? TickLabel{fmt::format("{:.{}f}", value, std::max(-k, 0))}
                                    : power_label(mantissa, k)});
    }
  }
  if (ticks.size() >= 3) return ticks;
  return linear_ticks(std::pow(10.0, view.low), std::pow(10.0, view.high), labels);
}

int nice_stride(int decades, int labels) {
  for (const int stride : {1, 2, 4, 5, 10, 20, 50, 100}) {
    if ((decades + stride - 1) / stride <= labels) return stride;
  }
  return 200;
}

std::vector<Tick> decade_ticks(const AxisView& view, int labels, bool minor) {
  std::vector<Tick> ticks;
  const int first = static_cast<int>(std::floor(view.low));
  const int last = static_cast<int>(std::floor(view.high + 1e-9));
  const int stride = nice_stride(last - first + 1, labels);
  for (int k = first; k <= last; ++k) {
    const double power = std::pow(10.0, k);
    const bool labelled = k % stride == 0;
    if (view.shows(power) && (labelled || last - first <= 24))
      ticks.push_back({power, labelled ? power_label(1, k) : TickLabel{}});
    for (int m = 2; minor && m <= 9; ++m) {
      if (view.shows(m * power)) ticks.push_back({m * power, {}, false});
    }
  }
  return ticks;
}

}  // namespace

bool AxisView::can_place(double value) const {
  return std::isfinite(value) && (scale == Scale::linear || value > 0);
}

double AxisView::fraction(double value) const { return (to_axis(scale, value) - low) / (high - low); }

bool AxisView::shows(double value) const {
  constexpr double slack = 1e-9;  // a tick or point on the frame counts as inside
  return can_place(value) && fraction(value) >= -slack && fraction(value) <= 1 + slack;
}

AxisView fit_axis(const Axis& axis, const std::vector<double>& values) {
  AxisView view{axis.scale, 0, 1};
  if (axis.range && view.can_place(axis.range->low) && view.can_place(axis.range->high)) {
    const double a = to_axis(axis.scale, axis.range->low);
    const double b = to_axis(axis.scale, axis.range->high);
    if (a != b) return {axis.scale, std::min(a, b), std::max(a, b)};
  }
  bool any = false;
  for (const double value : values) {
    if (!view.can_place(value)) continue;
    const double at = to_axis(axis.scale, value);
    view.low = any ? std::min(view.low, at) : at;
    view.high = any ? std::max(view.high, at) : at;
    any = true;
  }
  if (!any) return axis.scale == Scale::log10 ? AxisView{axis.scale, -1, 1} : AxisView{axis.scale, 0, 1};
  const double size = std::max(std::abs(view.low), std::abs(view.high));
  const double span = view.high - view.low;
  double margin = 0.04 * span;
  if (span <= 1e-12 * size || span == 0) {
    margin = 0.5;  // half a decade
    if (axis.scale == Scale::linear) margin = size > 0 ? 0.1 * size : 1;
  }
  return {axis.scale, view.low - margin, view.high + margin};
}

double pixel_width(const TickLabel& label, double font_size, double exponent_size) {
  return pixel_width(label.base, font_size) + pixel_width(label.exponent, exponent_size);
}

std::vector<Tick> choose_ticks(const AxisView& view, int labels, double roomy) {
  const int wanted = std::max(labels, 2);
  if (view.scale == Scale::linear) return linear_ticks(view.low, view.high, wanted);
  const double span = view.high - view.low;
  if (std::floor(view.high + 1e-9) - std::ceil(view.low - 1e-9) < 1) return short_log_ticks(view, wanted);
  return decade_ticks(view, wanted, 1 / span >= roomy);
}

}  // namespace odemark
