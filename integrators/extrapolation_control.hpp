// The loop of extrapolation methods: order and step chosen together for the least work per unit of time.
#pragma once

#include "integrators/integrate.hpp"

namespace odemark {

/// The report of a method that cannot take steps of a given size.
inline RunReport chooses_its_own_steps(double t0) {
  RunReport report;
  report.status = RunStatus::not_applicable;
  report.reason = "chooses its own steps: give a tolerance";
  report.t_reached = t0;
  return report;
}

/// For every row what step would have met the tolerance, and what a unit of time costs with it
/// (P. Deuflhard, Numer. Math. 41 (1983) 399-422; Hairer, Norsett & Wanner, Solving ODEs I, II.9).
template <class Table>
class ExtrapolationPlan {
 public:
  ExtrapolationPlan(const ErrorControl& control, double h) : safety_(control.safety), h_(h) {
    const double digits = -std::log10(control.relative_tolerance + control.absolute_tolerance);
    const double wished = std::isfinite(digits) ? 0.6 * digits + 0.5 : 2;
    target_ = std::clamp<std::size_t>(wished > 2 ? std::size_t(wished) : 2, 2, highest);
  }

  double h() const { return h_; }
  std::size_t last_row() const { return target_ + 1; }
  /// Rows before the window around the target are not expected to suffice, except where nothing is known.
  /// The second row alone has nothing below it to be compared with: a run would never leave it.
  bool may_end_at(std::size_t row) const { return first_ || (row >= 2 && row + 1 >= target_); }

  /// Takes note of the error norm of a row tried with step h.
  void note(std::size_t row, double h, double error) {
    const double power = 1.0 / Table::error_power(row), most = std::pow(0.02, power);
    const double factor = safety_ * std::pow(0.65 / std::max(error, 1e-30), power);
    wished_[row] = h * std::clamp(factor, most / 4, 1 / most);
    cost_[row] = Table::work(row) / (h * factor);  // not that of the cap, which is tighter for high orders
  }

  /// Can the rows that are left still bring this error below 1? Each divides it by a ratio of substeps.
  bool hopeless(std::size_t row, double error) const {
    double reach = 1;
    for (std::size_t j = row + 1; j <= last_row(); ++j)
      reach *= double(Table::substeps(j)) / Table::substeps(0);
    return !(error <= (Table::expansion_power == 2 ? reach * reach : reach));
  }

  void accept(std::size_t row) {
    std::size_t best = row;
    if (row > 2 && cost_[row - 1] < 0.8 * cost_[row])
      best = row - 1;
    else if (row >= 2 && cost_[row] < 0.9 * cost_[row - 1] && !rejected_)
      best = row + 1;
    best = std::clamp<std::size_t>(best, 2, highest);
    const double before = h_;
    h_ = best <= row ? wished_[best] : wished_[row] * Table::work(best) / Table::work(row);
    if (rejected_) h_ = std::min(h_, before);  // after a rejection the step must not grow at once
    target_ = best, first_ = rejected_ = false;
  }

  /// `rows` were tried with h in vain; none of them if the first could not even be computed.
  void reject(std::size_t rows, double h) {
    h_ = h / 4;
    if (rows > target_) {
      if (target_ > 2 && cost_[target_ - 1] < 0.9 * cost_[target_]) --target_;
      h_ = std::min(wished_[target_], 0.9 * h);
    } else if (rows >= 2) {
      h_ = std::min(wished_[rows - 1], 0.5 * h);
      target_ = std::max<std::size_t>(rows - 1, 2);
    }
    rejected_ = true;
  }

 private:
  static constexpr std::size_t highest = Table::rows - 2;
  double safety_, h_;
  std::size_t target_;
  bool first_ = true, rejected_ = false;
  std::array<double, Table::rows> wished_{}, cost_{};
};

template <class Table, System P, class Observer>
RunReport extrapolate(const P& system, const ErrorControl& control, double t0, double t1,
                      typename P::State& y, Observer& observe) {
  using Real = RealOf<typename P::State>;
  Table table(system, y);
  typename P::State next = blank_like(y), difference = zeros_like(y);
  ExtrapolationPlan<Table> plan(control, first_step(system, control, Table::error_power(1), t0, t1, y));
  RunReport report;
  Real t = Real(t0);
  const auto stop = [&](RunStatus status) {
    report.status = status, report.t_reached = double(t), report.newton = table.counts();
    return report;
  };
  bool begun = false, failed = false;
  while (t < Real(t1)) {
    if (report.accepted + report.rejected >= control.step_limit) return stop(RunStatus::step_limit);
    Real h = Real(plan.h());
    if (!(h > std::numeric_limits<Real>::epsilon() * std::abs(t)) ||
        !(h > std::numeric_limits<Real>::min())) {
      if (!all_finite(y)) return stop(RunStatus::not_finite);
      return stop(failed ? RunStatus::newton_diverged : RunStatus::step_underflow);
    }
    const bool last = t + h * Real(1.0001) >= Real(t1);
    if (last) h = Real(t1) - t;
    if (!begun) table.begin(t, y);
    begun = true, failed = false;
    bool accepted = false;
    std::size_t row = 0;
    for (; row <= plan.last_row() && !accepted; ++row) {
      failed = !table.add_row(row, t, y, h, next, difference);
      if (failed) break;
      if (row == 0) continue;
      const double error = error_norm(difference, y, next, control);
      if (!std::isfinite(error)) break;
      plan.note(row, double(h), error);
      if (!plan.may_end_at(row)) continue;
      accepted = error <= 1;
      if (!accepted && plan.hopeless(row, error)) {
        ++row;
        break;
      }
    }
    if (!accepted) {
      ++report.rejected;
      plan.reject(row, double(h));
      continue;
    }
    plan.accept(row - 1);
    begun = false;
    const Real t_next = last ? Real(t1) : t + h;
    ++report.accepted;
    const bool go_on = observe(t, y, t_next, next);
    std::swap(y, next);
    t = t_next;
    if (!go_on) return stop(RunStatus::time_limit);
  }
  return stop(all_finite(y) ? RunStatus::reached_end : RunStatus::not_finite);
}

}  // namespace odemark
