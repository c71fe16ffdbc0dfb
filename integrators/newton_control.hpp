// When a simplified Newton iteration has converged, when it is hopeless, and what that says about the step.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "integrators/step_control.hpp"

namespace odemark {

enum class NewtonVerdict { go_on, converged, hopeless };

/// Iterates as far as rounding allows. All sizes are sums of absolute values; `terms` is what the unknown is
/// the small difference of. A NaN is hopeless.
template <class Real>
class RoundOffStop {
 public:
  explicit RoundOffStop(int most) : most_(most) {}

  /// A Jacobian from here would save several iterations, and here is near enough to the solution: far from it
  /// a new one may lead to another solution.
  bool is_slow() const { return slow_ && previous_ < first_ / 64; }

  NewtonVerdict judge(Real moved, Real size, Real terms) {
    constexpr Real unit = std::numeric_limits<Real>::epsilon();
    if (!std::isfinite(moved + size)) return NewtonVerdict::hopeless;
    // the next correction would be lost in the last bit; or corrections that no longer shrink, small already
    const bool invisible =
        moved <= unit * size / 8 || (iteration_ > 0 && moved * moved <= unit * size / 8 * previous_);
    const bool stalled = moved >= previous_ / 2 && moved <= 4096 * unit * (size + terms);
    if (invisible || stalled || moved == 0) return NewtonVerdict::converged;
    slow_ = moved > previous_ / 8;
    if (iteration_ == 0) first_ = moved;
    if (++iteration_ >= most_) return NewtonVerdict::hopeless;
    if (most_ <= 20 && iteration_ > 3 && moved > 2 * previous_) return NewtonVerdict::hopeless;
    previous_ = moved;
    return NewtonVerdict::go_on;
  }

 private:
  int most_, iteration_ = 0;
  bool slow_ = false;
  Real first_ = 0, previous_ = std::numeric_limits<Real>::infinity();
};

/// power: the tolerance of the iteration and of the estimate is 0.1 tolerance^power where that is below 1; an
/// estimate of lower order than the step then keeps errors proportional to what was asked. kappa: what of
/// that tolerance the iteration may leave, 0 for min(0.03, its root). fast: the rate up to which a Jacobian
/// is kept.
struct NewtonSettings {
  double power, kappa;
  int most;
  double fast;
};

/// Newton under error control, after E. Hairer, G. Wanner, Solving ODEs II, IV.8, eq. 8.10-8.12: theta is the
/// rate of contraction, and eta = theta / (1 - theta) bounds the rest by the last correction.
template <class Real>
class NewtonControl {
 public:
  void start(const ErrorControl& control, const NewtonSettings& settings) {
    control_ = &control;
    const double asked =
        control.relative_tolerance > 0 ? control.relative_tolerance : control.absolute_tolerance;
    const double used = settings.power < 1 ? std::min(0.1 * std::pow(asked, settings.power), 0.1) : asked;
    ratio_ = used / asked;
    const double unit = double(std::numeric_limits<Real>::epsilon());
    kappa_ = Real(
        std::max(10 * unit / used, settings.kappa > 0 ? settings.kappa : std::min(0.03, std::sqrt(used))));
    most_ = settings.most, fast_ = Real(settings.fast);
    eta_ = 1, theta_ = 1, failed_factor_ = 0.5;
    failed_ = false;
    last_h_ = 0;
    first_ = true;
  }
  /// The first step is not the first of the run.
  void resume() { first_ = false; }

  double tolerance_ratio() const { return ratio_; }
  double inverse_weight(std::size_t n, double size) const {
    return 1 / (ratio_ * error_weight(*control_, n, size));
  }
  /// Of an error not yet divided by tolerance_ratio().
  template <State S>
  double norm(const S& error, const S& y) const {
    double sum = 0;
    for_each_component(y, [&](std::size_t n) {
      const double ratio = double(error.data()[n]) * inverse_weight(n, std::abs(double(y.data()[n])));
      sum += ratio * ratio;
    });
    return std::sqrt(sum / static_cast<double>(size_of(y)));
  }

  void begin_step() { iterations_ = 0, slowest_ = 0; }
  /// Of one system of a step; diagonally implicit methods solve several. `renewed`: the step is not the last
  /// one again. Where one iteration was enough for steps a fifth as long, its rate says nothing of this one:
  /// on van_der_pol_mu1000 a step after the jump ended 3600 tolerances off.
  void begin(bool renewed = false) {
    iteration_ = 0;
    const Real root = std::sqrt(std::max(eta_, std::numeric_limits<Real>::epsilon()));
    eta_ = root * std::sqrt(root);  // eta^0.75: the rate of the last step, trusted a little less ...
    if (renewed) eta_ = std::max(eta_, Real(0.01));  // ... and not at all beyond two digits
  }
  NewtonVerdict judge(Real moved) {
    ++iteration_;
    iterations_ = std::max(iterations_, iteration_);
    failed_factor_ = 0.5;
    if (iteration_ > 1) {
      const Real rate = moved / previous_;
      theta_ = iteration_ == 2 ? rate : std::sqrt(rate * previous_rate_);
      previous_rate_ = rate;
      slowest_ = std::max(slowest_, theta_);
      if (!(theta_ < Real(0.99))) return NewtonVerdict::hopeless;
      eta_ = theta_ / (1 - theta_);
      Real left = eta_ * moved;
      for (int i = iteration_; i < most_ - 1; ++i) left *= theta_;
      if (left >= kappa_) {  // it would not come there in time: how much shorter must the step be?
        const double excess = std::clamp(double(left / kappa_), 1e-4, 20.0);
        failed_factor_ = 0.8 * std::pow(excess, -1.0 / (3 + most_ - iteration_));
        if (iteration_ < most_) return NewtonVerdict::hopeless;
      }
    }
    previous_ = std::max(moved, std::numeric_limits<Real>::min());
    if (eta_ * moved <= kappa_) return NewtonVerdict::converged;
    return iteration_ < most_ && moved == moved ? NewtonVerdict::go_on : NewtonVerdict::hopeless;
  }

  /// Of the last step: the slowest rate seen (0 where one iteration was enough), most iterations.
  bool converges_fast() const { return slowest_ <= fast_; }
  Real slowest_rate() const { return slowest_; }

  /// The factor on h for the `wished` one of a step-size filter; `norm` is the error of the last attempt, NaN
  /// where it failed.
  double choose_factor(double wished, double norm) {
    if (!(norm < 1e300)) {
      failed_ = true;
      return std::isnan(norm) ? failed_factor_ : wished;
    }
    if (!(norm <= 1)) return wished;
    wished *= patience();
    if (failed_) wished = std::min(wished, 1.0);
    failed_ = false;
    return settle(wished);
  }

  /// The predictive controller (K. Gustafsson, ACM TOMS 20 (1994) 496-517; Solving ODEs II, IV.8, eq. 8.25):
  /// errors of stiff problems grow by the same factor from step to step, and this one sees it coming.
  double predict_factor(double h, double norm, int error_order) {
    const ErrorControl& c = *control_;
    if (!(norm < 1e300)) {
      failed_ = true;
      return failed_factor_;
    }
    const double root = inverse_root(std::max(norm, 1e-10), error_order);
    double wished = c.safety * patience() * root;
    if (!(norm <= 1)) {
      failed_ = true;
      return first_ ? 0.1 : std::clamp(wished, c.smallest_factor, c.safety);
    }
    if (last_h_ != 0) wished = std::min(wished, c.safety * h / last_h_ * root * root / last_root_);
    last_h_ = h;
    first_ = false;
    last_root_ = inverse_root(std::max(norm, 1e-2), error_order);
    wished = std::clamp(wished, c.smallest_factor, failed_ ? 1.0 : c.largest_factor);
    failed_ = false;
    return settle(wished);
  }

 private:
  const ErrorControl* control_ = nullptr;
  double ratio_ = 1, failed_factor_ = 0.5;
  Real kappa_ = 0, eta_ = 1, theta_ = 1, previous_ = 1, previous_rate_ = 1, fast_ = 0, slowest_ = 0;
  /// Many iterations are a warning (Solving ODEs II, IV.8, eq. 8.21).
  double patience() const { return double(2 * most_ + 1) / double(2 * most_ + iterations_); }
  /// The same step keeps the factors, which are worth more than a fifth of a step.
  double settle(double factor) const {
    return factor >= 1 && factor <= 1.2 && converges_fast() ? 1.0 : factor;
  }
  static double inverse_root(double x, int order) {
    return order == 4   ? 1 / std::sqrt(std::sqrt(x))
           : order == 8 ? 1 / std::sqrt(std::sqrt(std::sqrt(x)))
                        : std::pow(x, -1.0 / order);
  }

  int most_ = 7, iteration_ = 0, iterations_ = 0;
  bool failed_ = false, first_ = true;
  double last_h_ = 0, last_root_ = 1;
};

}  // namespace odemark
