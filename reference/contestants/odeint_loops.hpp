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

/// `try_step(t, h)` is a controlled stepper's: true where it advanced the state and t; it changes h either
/// way. `accepted(t_old, t)` false stops the run.
template <class TryStep, class Accepted, class Finite>
RunReport odeint_steps(const ErrorControl& control, double h, double t0, double t1, TryStep&& try_step,
                       Accepted&& accepted, Finite&& finite) {
  RunReport report;
  double t = t0;
  while (t < t1) {
    if (report.accepted + report.rejected >= control.step_limit)
      return ended(report, RunStatus::step_limit, t);
    if (vanishes(h, t)) return ended(report, RunStatus::step_underflow, t);
    const bool last = t + h * 1.0001 >= t1;
    if (last) h = t1 - t;
    const double t_before = t;
    if (!try_step(t, h)) {
      ++report.rejected;
      continue;
    }
    ++report.accepted;
    if (last) t = t1;
    if (!accepted(t_before, t)) return ended(report, RunStatus::time_limit, t);
  }
  return ended(report, finite() ? RunStatus::reached_end : RunStatus::not_finite, t);
}

/// The same on job.y, watched; it goes no further once the state is not finite.
template <class TryStep, class Between>
RunReport odeint_controlled(const Job& job, double h, TryStep&& try_step, Between&& between) {
  Recorder recorder(job);
  std::vector<double> before(job.y);
  bool finite = true;
  const auto watched_step = [&](double& t, double& step) {
    if (recorder.traced()) before = job.y;
    return try_step(t, step);
  };
  const auto accepted = [&](double t_before, double t) {
    finite = all_finite(job.y);
    const auto value = [&](double time, double* out) { return between(t_before, before, time, out); };
    return finite && recorder.accepted(t, job.y.data(), value);
  };
  RunReport report = odeint_steps(*job.adaptive(), h, job.t0, job.t1, watched_step, accepted,
                                  [&] { return all_finite(job.y); });
  if (!finite) report.status = RunStatus::not_finite;
  return report;
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
