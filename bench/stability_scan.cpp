// Scanning up in narrow cells, bisecting inside every cell where the verdict changes.
#include "bench/stability_scan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace odemark {

namespace {

class Scanner {
 public:
  Scanner(const StepProbe& probe, const ScanRange& range) : probe_(probe), range_(range) {}

  Scan run() {
    const double rate = range_.fastest_rate;
    const double fine = range_.expected > 0 ? std::min(0.02 / rate, 0.01 * range_.expected) : 0.02 / rate;
    const double coarse_from = 1.2 * range_.expected;
    const double end = std::max({60 / rate, 1.2 * range_.expected, 1.2 * range_.last_expected});
    while (at_ < end && scan_.failure.empty())
      advance(at_ < coarse_from || edges_.empty() ? at_ + fine : at_ + std::max(0.02 / rate, 0.005 * at_));
    while (edges_.empty() && at_ < 1e6 / rate && scan_.failure.empty()) advance(at_ * 1.2);
    scan_.scanned_to = at_;
    if (scan_.failure.empty()) conclude();
    return scan_;
  }

 private:
  bool stable(double dt) {
    const auto step = probe_(dt);
    if (!step.solved && scan_.failure.empty())
      scan_.failure = fmt::format("an implicit stage could not be solved at dt = {:.6g} s", dt);
    if (std::isnan(step.growth) && step.solved && dt * range_.fastest_rate < 1e3 && scan_.failure.empty())
      scan_.failure = fmt::format("the step has an entry that is not finite at dt = {:.6g} s", dt);
    return step.growth <= static_cast<long double>(probe_.tolerance());
  }

  void advance(double next) {
    const bool good = stable(next);
    if (good != was_good_ && scan_.failure.empty()) edges_.push_back(bisect(at_, next));
    at_ = next, was_good_ = good;
  }

  double bisect(double low, double high) {
    const bool good = was_good_;
    while (true) {
      const double middle = low + (high - low) / 2;
      if (!(middle > low && middle < high)) return low;
      (stable(middle) == good ? low : high) = middle;
    }
  }

  /// How far the edge may be off: growth is only known to the tolerance and the noise, and grows from there.
  double resolution(double edge) const {
    const auto here = probe_(edge, true);
    const long double unknown = static_cast<long double>(probe_.tolerance()) + here.noise;
    double step = 1e-6 * edge;
    for (; step < 0.01 * edge; step *= 10)
      if (probe_(edge + step).growth - here.growth > 10 * unknown) break;
    const long double slope = (probe_(edge + step).growth - here.growth) / static_cast<long double>(step);
    return slope > 0 ? double(unknown / slope) + 4e-16 * edge : edge;
  }

  void conclude() {
    if (edges_.empty()) {
      scan_.verdict = "unlimited";
      return;
    }
    const double edge = edges_.front();
    // Growth that is above rounding well inside the edge does not begin at the edge: that is only where a
    // power law such as Heun's (w dt)^4 / 8 passes the tolerance. A true limit is followed downwards by
    // decay, or by nothing at all.
    if (probe_(0.95 * edge).growth > static_cast<long double>(probe_.floor())) {
      scan_.verdict = "unstable";
      scan_.resolution = edge;
    } else {
      scan_.verdict = "limit";
      scan_.limit = edge;
      scan_.resolution = resolution(edge);
    }
    for (std::size_t i = 1; i < edges_.size(); i += 2)
      scan_.later_bands.emplace_back(edges_[i], i + 1 < edges_.size() ? edges_[i + 1] : scan_.scanned_to);
  }

  const StepProbe& probe_;
  const ScanRange range_;
  Scan scan_;
  double at_ = 0;
  bool was_good_ = true;
  std::vector<double> edges_;  // dt where the verdict changes, from stable to unstable first
};

}  // namespace

Scan scan_step_sizes(const StepProbe& probe, const ScanRange& range) { return Scanner(probe, range).run(); }

}  // namespace odemark
