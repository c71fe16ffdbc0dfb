// How the step size is chosen. Two policies: a fixed grid, or error control by a digital filter.
#pragma once

#include <algorithm>
#include <cmath>
#include <string_view>
#include <variant>

#include "integrators/state.hpp"

namespace odemark {

/// A whole number of equal steps, so that the last one lands on the end without a remainder.
/// `compensated` carries the rounding error of the state from step to step.
struct FixedSteps {
  long count;
  bool compensated = false;
};

/// Exponents of the step-size filter; presets below. G. Soderlind, ACM TOMS 29 (2003) 1-26.
struct StepFilter {
  std::string_view id;
  double error, previous_error, previous_ratio;
};
inline constexpr StepFilter elementary_filter{"elementary", 1.0, 0.0, 0.0};
inline constexpr StepFilter pi_filter{"pi", 0.7, -0.4, 0.0};
inline constexpr StepFilter h211b_filter{"h211b", 0.25, 0.25, 0.25};
inline constexpr std::array<const StepFilter*, 3> step_filters{&elementary_filter, &pi_filter, &h211b_filter};

/// A step is accepted when the weighted RMS of its error estimate is at most 1; the weight of component i is
/// relative_tolerance * |y_i| + absolute_tolerance * scale_i, with scale_i = 1 where `scale` is null.
struct ErrorControl {
  double relative_tolerance, absolute_tolerance;
  StepFilter filter = pi_filter;
  double safety = 0.9, smallest_factor = 0.2, largest_factor = 5.0;
  double first_step = 0;  // 0: estimated from the first slope (Hairer, Norsett & Wanner I, II.4)
  long step_limit = 10'000'000;
  const double* scale = nullptr;  // natural size of each component, as many as the state has
};

using Control = std::variant<FixedSteps, ErrorControl>;

inline double error_weight(const ErrorControl& control, std::size_t i, double size) {
  return control.relative_tolerance * size +
         control.absolute_tolerance * (control.scale ? control.scale[i] : 1);
}

/// Weighted root mean square; at most 1 means the step is accurate enough. NaN stays NaN.
template <State S>
double error_norm(const S& error, const S& y, const S& next, const ErrorControl& control) {
  double sum = 0;
  for_each_component(y, [&](std::size_t i) {
    const double before = std::abs(double(y.data()[i])), after = std::abs(double(next.data()[i]));
    const double ratio = double(error.data()[i]) / error_weight(control, i, before > after ? before : after);
    sum += ratio * ratio;
  });
  return std::sqrt(sum / static_cast<double>(size_of(y)));
}

/// Remembers the last error and factor; turns each error norm into the factor for the next step.
class StepSizeFilter {
 public:
  StepSizeFilter(const ErrorControl& control, int error_order)
      : control_(control), order_(error_order), target_(std::pow(control.safety, error_order)) {}

  /// Factor to apply to h. `norm` <= 1 was accepted; NaN counts as a failure and shrinks hardest.
  double next_factor(double norm) {
    if (!(norm < 1e300)) return control_.smallest_factor;
    const double excess = std::max(norm, 1e-10) / target_;
    const auto& f = control_.filter;
    const bool accepted = norm <= 1;
    double wished = std::pow(excess, -(accepted ? f.error : 1.0) / order_);
    if (accepted && f.previous_error != 0) wished *= std::pow(last_excess_, -f.previous_error / order_);
    if (accepted && f.previous_ratio != 0) wished *= std::pow(last_factor_, -f.previous_ratio);
    // after a rejection the step must not grow at once
    const double ceiling = accepted ? (rejected_ ? 1.0 : control_.largest_factor) : control_.safety;
    const double factor = std::clamp(wished, control_.smallest_factor, ceiling);
    if (accepted) last_excess_ = excess, last_factor_ = factor;
    rejected_ = !accepted;
    return factor;
  }

 private:
  const ErrorControl& control_;
  int order_;
  double target_;  // the error norm to aim at: `safety` is a margin on h, so its power is one on the error
  double last_excess_ = 1, last_factor_ = 1;
  bool rejected_ = false;
};

}  // namespace odemark
