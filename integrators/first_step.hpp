// Where error control starts.
#pragma once

#include <algorithm>
#include <cmath>

#include "integrators/step_control.hpp"

namespace odemark {

/// First step by the slope and its change over a trial Euler step (Hairer, Norsett & Wanner I, II.4): a
/// method whose error grows like h^error_order then starts with an error of about a hundredth of the
/// tolerance. At most a tenth of the interval. Two evaluations.
template <class P>
double first_step(const P& system, const ErrorControl& control, int error_order, double t0, double t1,
                  const typename P::State& y) {
  using Real = RealOf<typename P::State>;
  if (control.first_step > 0) return control.first_step;
  typename P::State slope = zeros_like(y), trial = y, later = slope;
  system.rhs(Real(t0), y, slope);
  double size = 0, speed = 0;
  for_each_component(y, [&](std::size_t i) {
    const double weight = error_weight(control, i, std::abs(double(y.data()[i])));
    const double a = double(y.data()[i]) / weight, b = double(slope.data()[i]) / weight;
    size += a * a, speed += b * b;
  });
  const double n = static_cast<double>(size_of(y)), longest = (t1 - t0) / 10;
  size = std::sqrt(size / n), speed = std::sqrt(speed / n);
  double h = size < 1e-5 || speed < 1e-5 ? 1e-6 * (t1 - t0) : 0.01 * size / speed;
  if (!(h < longest)) h = longest;
  for_each_component(y, [&](std::size_t i) { trial.data()[i] = y.data()[i] + Real(h) * slope.data()[i]; });
  system.rhs(Real(t0 + h), trial, later);
  double bend = 0;
  for_each_component(y, [&](std::size_t i) {
    const double weight = error_weight(control, i, std::abs(double(y.data()[i])));
    const double c = double(later.data()[i] - slope.data()[i]) / weight;
    bend += c * c;
  });
  const double steepest = std::max(speed, std::sqrt(bend / n) / h);
  const double wished =
      steepest > 1e-15 ? std::pow(0.01 / steepest, 1.0 / error_order) : std::max(1e-6 * (t1 - t0), h * 1e-3);
  const double first = std::min(std::min(100 * h, wished), longest);
  return std::isfinite(first) && first > 0 ? first : h;
}

}  // namespace odemark
