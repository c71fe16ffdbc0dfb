// Scanning up in narrow cells, bisecting inside every cell where the verdict changes.
#include "bench/stability_scan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace odemark {

namespace {

class Scanner {
 public:
  Scanner(const ScanSubject& subject, const ScanRange& range) : subject_(subject), range_(range) {}

  Scan run() {
    const double rate = range_.fastest_rate;
    const double fine = range_.expected > 0
                            ? std::min(0.02 / rate, std::max(0.01 * range_.expected, 1e-4 / rate))
                            : 0.02 / rate;
    const double coarse_from = 1.2 * range_.expected;
    const double end = std::max({60 / rate, 1.2 * range_.expected, 1.2 * range_.last_expected});
    while (at_ < end && scan_.failure.empty())
      advance(at_ < coarse_from || edges_.empty() ? at_ + fine : at_ + std::max(0.02 / rate, 0.005 * at_));
    const auto tells = [&] { return at_ < 1e6 / rate && subject_.tolerance(1.2 * at_ * rate) < 0.01; };
    while (edges_.empty() && tells() && scan_.failure.empty()) advance(at_ * 1.2);
    scan_.scanned_to = at_;
    if (scan_.failure.empty()) conclude();
    return scan_;
  }

 private:
  bool stable(double dt) {
    const auto step = subject_.growth(dt);
    if (!step.solved && scan_.failure.empty())
      scan_.failure = fmt::format("an implicit stage could not be solved at dt = {:.6g} s", dt);
    if (std::isnan(step.growth) && step.solved && dt * range_.fastest_rate < 1e3 && scan_.failure.empty())
      scan_.failure = fmt::format("the step has an entry that is not finite at dt = {:.6g} s", dt);
    return step.growth <= tolerance(dt);
  }

  long double tolerance(double dt) const { return subject_.tolerance(dt * range_.fastest_rate); }
  long double growth(double dt) const { return subject_.growth(dt).growth; }

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
    const long double unknown = tolerance(edge) + subject_.noise(edge), here = growth(edge);
    double step = 1e-6 * edge;
    for (; step < 0.01 * edge; step *= 10)
      if (growth(edge + step) - here > 10 * unknown) break;
    const long double slope = (growth(edge + step) - here) / static_cast<long double>(step);
    return slope > 0 ? double(unknown / slope) + 4e-16 * edge : edge;
  }

  /// Where several eigenvalues meet at the edge, noise rises towards it as a root of the distance, and the
  /// scan stops short. Instability is certain where it stands out of the noise; the edge lies before that.
  double onset(double edge) const {
    double step = 1e-10 * edge;
    for (; step < 0.01 * edge; step *= 4)
      if (growth(edge + step) > 10 * (tolerance(edge + step) + subject_.noise(edge + step))) break;
    return step;
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
    const long double floor = static_cast<long double>(subject_.floor);
    if (growth(0.95 * edge) > floor && growth(0.9 * edge) > floor) {
      scan_.verdict = "unstable";
      scan_.resolution = edge;
    } else {
      scan_.verdict = "limit";
      scan_.limit = edge;
      scan_.resolution = resolution(edge);
      if (range_.expected > 0 &&
          std::abs(edge - range_.expected) > std::max(1e-9 * range_.expected, scan_.resolution))
        scan_.resolution = onset(edge);
    }
    for (std::size_t i = 1; i < edges_.size(); i += 2) {
      const double low = edges_[i], high = i + 1 < edges_.size() ? edges_[i + 1] : scan_.scanned_to;
      if (high - low > 1e-6 * high)
        scan_.later_bands.emplace_back(low, high);  // else one point on the circle
    }
  }

  const ScanSubject& subject_;
  const ScanRange range_;
  Scan scan_;
  double at_ = 0;
  bool was_good_ = true;
  std::vector<double> edges_;  // dt where the verdict changes, from stable to unstable first
};

}  // namespace

ScanSubject subject_of(const StepProbe& probe) {
  return {[&probe](double dt) { return probe.judge(dt); }, [&probe](double z) { return probe.tolerance(z); },
          [&probe](double dt) { return probe.noise(dt); }, probe.floor()};
}

Scan scan_step_sizes(const ScanSubject& subject, const ScanRange& range) {
  return Scanner(subject, range).run();
}

}  // namespace odemark
