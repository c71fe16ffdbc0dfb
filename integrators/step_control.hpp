// How the step size is chosen. Two policies: a fixed grid, or error control by a digital filter.
#pragma once

#include <algorithm>
#include <cmath>
#include <string_view>
#include <variant>

#include "integrators/quick_power.hpp"
#include "integrators/state.hpp"

namespace odemark {

/// A whole number of equal steps, so that the last one lands on the end without a remainder.
/// `compensated` carries the rounding error of the state from step to step.
struct FixedSteps {
  long count;
  bool compensated = false;
};

/// Exponents of the step-size filter; presets below. G. Soderlind, ACM TOMS 29 (2003) 1-26. While the factor
/// that the error alone asks for lies in [keep_above, keep_below] the step stays as it is: the next step then
/// waits for nothing but its own start, the processor guesses the outcome and works on while the error is
/// still being measured. Outside the band the exponents are those of `pi`: with the elementary ones a step
/// held down by stability is rejected in a quarter of all attempts (bogacki_shampine32 on y' = -2000 (y - cos
/// t)), so in one of seventeen.
struct StepFilter {
  std::string_view id;
  double error, previous_error, previous_ratio;
  double keep_above = 1, keep_below = 1;  // 1, 1: the step is never kept
};
inline constexpr StepFilter elementary_filter{"elementary", 1.0, 0.0, 0.0};
inline constexpr StepFilter pi_filter{"pi", 0.7, -0.4, 0.0};
inline constexpr StepFilter h211b_filter{"h211b", 0.25, 0.25, 0.25};
inline constexpr StepFilter dead_band_filter{"dead_band", 0.7, -0.4, 0.0, 0.93, 1.33};
inline constexpr std::array<const StepFilter*, 4> step_filters{&elementary_filter, &pi_filter, &h211b_filter,
                                                               &dead_band_filter};
inline constexpr const StepFilter& default_filter = dead_band_filter;

/// A step is accepted when the weighted RMS of its error estimate is at most 1; the weight of component i is
/// relative_tolerance * |y_i| + absolute_tolerance * scale_i, with scale_i = 1 where `scale` is null.
struct ErrorControl {
  double relative_tolerance, absolute_tolerance;
  StepFilter filter = default_filter;
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

/// Weighted mean square; at most 1 means the step is accurate enough. NaN stays NaN. `floors` holds the
/// absolute part of every weight, absolute_tolerance * scale_i.
template <State S, class Floors>
[[gnu::always_inline]] inline double mean_square_error(const S& error, const S& y, const S& next,
                                                       double relative_tolerance, const Floors& floors) {
  double sum = 0;
  for_each_component(y, [&](std::size_t i) {
    const double before = std::abs(double(y.data()[i])), after = std::abs(double(next.data()[i]));
    const double ratio =
        double(error.data()[i]) / (relative_tolerance * (before > after ? before : after) + floors[i]);
    sum += ratio * ratio;
  });
  return sum / static_cast<double>(size_of(y));
}

/// Weighted root mean square, for loops that are no step-by-step loop of integrate.hpp. NaN stays NaN.
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

/// Remembers the last error and factor; turns each mean square of the error into the factor for the next
/// step.
class StepSizeFilter {
 public:
  StepSizeFilter(const ErrorControl& control, int error_order)
      : filter_(control.filter),
        order_(error_order),
        safety_(control.safety),
        smallest_(control.smallest_factor),
        largest_(control.largest_factor),
        target_(std::pow(control.safety, 2 * error_order)),
        keep_least_(target_ * std::pow(filter_.keep_below, -2 * error_order)),
        keep_most_(std::min(1.0, target_ * std::pow(filter_.keep_above, -2 * error_order))) {
    if (!(filter_.keep_above < filter_.keep_below)) keep_least_ = 2;
  }

  /// The error is so near what is aimed at that h stays.
  [[gnu::always_inline]] bool keeps(double square) const {
    return square >= keep_least_ && square <= keep_most_;
  }
  void kept(double square) {
    last_excess_ = square / target_;
    last_factor_ = 1;
    rejected_ = false;
  }
  /// Factor to apply to h. `square` <= 1 was accepted; NaN counts as a failure and shrinks hardest.
  [[gnu::noinline]] double next_factor(double square) {
    if (!(square < 1e300)) {
      rejected_ = true;
      return smallest_;
    }
    const double excess = std::max(square, 1e-20) / target_, half = -0.5 / order_;
    const bool accepted = square <= 1;
    double wished = quick_power(excess, half * (accepted ? filter_.error : 1.0));
    if (accepted && filter_.previous_error != 0)
      wished *= quick_power(last_excess_, half * filter_.previous_error);
    if (accepted && filter_.previous_ratio != 0) wished *= quick_power(last_factor_, -filter_.previous_ratio);
    // after a rejection the step must not grow at once
    const double ceiling = accepted ? (rejected_ ? 1.0 : largest_) : safety_;
    const double factor = std::clamp(wished, smallest_, ceiling);
    if (accepted) last_excess_ = excess, last_factor_ = factor;
    rejected_ = !accepted;
    return factor;
  }

 private:
  StepFilter filter_;
  int order_;
  double safety_, smallest_, largest_;
  double target_;  // the mean square to aim at: `safety` is a margin on h, so its power is one on the error
  double keep_least_, keep_most_;
  double last_excess_ = 1, last_factor_ = 1;
  bool rejected_ = false;
};

}  // namespace odemark
