// The loops around odeint's steppers: what integrate_const and integrate_adaptive do, limited and watched.
#pragma once

#include "reference/contestants/adapter.hpp"

namespace odemark::contestant {

/// `step(t, h)` advances job.y; `between(t_old, y_old, t, out)` writes a value inside the step.
template <class Step, class Between>
RunReport odeint_fixed(const Job& job, Step&& step, Between&& between) {
  RunReport report;
  Recorder recorder(job);
  std::vector<double> before(job.y);
  const double h = job.step_size();
  for (long n = 0; n < job.fixed()->count; ++n) {
    const double t = job.time_of(n), t_next = job.time_of(n + 1);
    if (recorder.traced()) before = job.y;
    step(t, h);
    ++report.accepted;
    const auto value = [&](double time, double* out) { return between(t, before, time, out); };
    if (!recorder.accepted(t_next, job.y.data(), value)) return ended(report, RunStatus::time_limit, t_next);
  }
  return ended(report, job.y, job.t1);
}

/// `try_step(t, h)` is a controlled stepper's: true where it advanced job.y and t; it changes h either way.
template <class TryStep, class Between>
RunReport odeint_controlled(const Job& job, double h, TryStep&& try_step, Between&& between) {
  RunReport report;
  Recorder recorder(job);
  std::vector<double> before(job.y);
  double t = job.t0;
  while (t < job.t1) {
    if (report.accepted + report.rejected >= job.adaptive()->step_limit)
      return ended(report, RunStatus::step_limit, t);
    if (vanishes(h, t)) return ended(report, RunStatus::step_underflow, t);
    const bool last = t + h * 1.0001 >= job.t1;
    if (last) h = job.t1 - t;
    const double t_before = t;
    if (recorder.traced()) before = job.y;
    if (!try_step(t, h)) {
      ++report.rejected;
      continue;
    }
    ++report.accepted;
    if (last) t = job.t1;
    if (!all_finite(job.y)) return ended(report, RunStatus::not_finite, t);
    const auto value = [&](double time, double* out) { return between(t_before, before, time, out); };
    if (!recorder.accepted(t, job.y.data(), value)) return ended(report, RunStatus::time_limit, t);
  }
  return ended(report, job.y, t);
}

/// A system in units of each component's natural size: odeint's own error tests know one absolute tolerance
/// for all, and in these units it means absolute_tolerance * scale_i. Without scales nothing is multiplied.
class InUnits {
 public:
  InUnits(const ErasedSystem<double>& system, const double* scale)
      : system_(system), scale_(scale), y_(scale ? system.size : 0) {}

  void rhs(double t, const double* z, double* dzdt) const {
    system_.rhs_call(system_.self, t, in_problem_units(z), dzdt);
    for (std::size_t i = 0; i < y_.size(); ++i) dzdt[i] /= scale_[i];
  }
  /// Column-major, in the problem's units; divide by size_of(row) and multiply by size_of(column).
  void jacobian(double t, const double* z, double* column_major) const {
    system_.jacobian_call(system_.self, t, in_problem_units(z), column_major);
  }
  void into(std::vector<double>& y) const {
    for (std::size_t i = 0; i < y_.size(); ++i) y[i] /= scale_[i];
  }
  void back(std::vector<double>& z) const {
    for (std::size_t i = 0; i < y_.size(); ++i) z[i] *= scale_[i];
  }
  double size_of(std::size_t i) const { return scale_ ? scale_[i] : 1; }
  std::size_t size() const { return system_.size; }

 private:
  const double* in_problem_units(const double* z) const {
    if (!scale_) return z;
    for (std::size_t i = 0; i < y_.size(); ++i) y_[i] = z[i] * scale_[i];
    return y_.data();
  }
  const ErasedSystem<double>& system_;
  const double* scale_;
  mutable std::vector<double> y_;  // empty without scales
};

}  // namespace odemark::contestant
