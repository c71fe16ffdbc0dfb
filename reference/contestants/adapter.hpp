// The one shape behind which every third-party solver runs: what it is asked, what it may call, what it
// records.
#pragma once

#include <cmath>
#include <exception>
#include <utility>

#include "integrators/any_method.hpp"

namespace odemark::contestant {

/// One run asked of a solver. `bare` and `trace` are null in an untraced run.
struct Job {
  const ErasedSystem<double>& system;
  const ErasedSystem<double>* bare;
  const Control& control;
  double t0, t1;
  std::vector<double>& y;
  Trace<double>* trace;

  const FixedSteps* fixed() const { return std::get_if<FixedSteps>(&control); }
  const ErrorControl* adaptive() const { return std::get_if<ErrorControl>(&control); }
  double step_size() const { return (t1 - t0) / double(fixed()->count); }
  /// t0 + n h, and exactly t1 at the end: never accumulated.
  double time_of(long n) const { return n == fixed()->count ? t1 : t0 + double(n) * step_size(); }
};

/// What a reader may know of a solver before it runs.
struct Row {
  std::string_view id, kind, source;
  int order = 0, embedded_order = 0;
  unsigned needs = 0;
  bool fixed_steps = true, error_control = true, multistep = false;
  std::string_view note = "";
};

/// Stands between a C library and a problem: an exception must not unwind through C, so it waits here.
class Callee {
 public:
  explicit Callee(const ErasedSystem<double>& system) : system_(&system) {}

  /// False: the problem threw, and the solver must stop.
  bool rhs(double t, const double* y, double* dydt) noexcept {
    return call([&] { system_->rhs_call(system_->self, t, y, dydt); });
  }
  /// Column-major; every entry is written.
  bool jacobian(double t, const double* y, double* column_major) noexcept {
    std::fill(column_major, column_major + size() * size(), 0.0);
    return call([&] { system_->jacobian_call(system_->self, t, y, column_major); });
  }
  /// In the storage of the system's band; entries outside of the family's pattern are left alone.
  bool band(double t, const double* y, double* band) noexcept {
    return call([&] { system_->band_call(system_->self, t, y, band); });
  }
  std::size_t size() const { return system_->size; }
  bool has_jacobian() const { return (system_->abilities & Ability::jacobian) && system_->jacobian_call; }
  bool threw() const { return thrown_ != nullptr; }
  void rethrow() {
    if (thrown_) std::rethrow_exception(std::exchange(thrown_, nullptr));
  }
  /// Lets `f` evaluate another system, so that values between steps are not counted as the run's work.
  template <class F>
  void with(const ErasedSystem<double>& other, F&& f) {
    const auto* before = std::exchange(system_, &other);
    f();
    system_ = before;
  }

 private:
  template <class F>
  bool call(F&& f) noexcept {
    if (thrown_) return false;
    try {
      f();
      return true;
    } catch (...) {
      thrown_ = std::current_exception();
      return false;
    }
  }
  const ErasedSystem<double>* system_;
  std::exception_ptr thrown_;
};

/// Fills the samples of a trace and asks its observer whether to go on. Does nothing in an untraced run.
class Recorder {
 public:
  explicit Recorder(const Job& job)
      : trace_(job.trace),
        size_(job.system.size),
        close_(8 * std::numeric_limits<double>::epsilon() * std::max(std::abs(job.t0), std::abs(job.t1))) {
    if (trace_) trace_->samples.assign(trace_->grid.size() * size_, std::numeric_limits<double>::quiet_NaN());
  }

  /// After an accepted step to (t, y). `between(time, out)` writes the state inside that step; where it says
  /// false the row stays NaN. False: the run is to stop (time_limit).
  template <class Between>
  bool accepted(double t, const double* y, Between&& between) {
    if (!trace_) return true;
    for (; next_ < trace_->grid.size() && trace_->grid[next_] <= t + close_; ++next_) {
      double* out = trace_->samples.data() + next_ * size_;
      if (trace_->grid[next_] >= t - close_)
        std::copy(y, y + size_, out);
      else if (!between(trace_->grid[next_], out))
        std::fill(out, out + size_, std::numeric_limits<double>::quiet_NaN());
    }
    return !trace_->on_step || trace_->on_step(t, y);
  }
  bool traced() const { return trace_ != nullptr; }

 private:
  Trace<double>* trace_;
  std::size_t size_, next_ = 0;
  double close_;
};

inline RunReport ended(RunReport report, RunStatus status, double t, std::string_view reason = "") {
  report.status = status, report.t_reached = t, report.reason = reason;
  return report;
}

/// The end of a run that took all its steps: the state decides.
inline RunReport ended(RunReport report, const std::vector<double>& y, double t) {
  return ended(report, all_finite(y) ? RunStatus::reached_end : RunStatus::not_finite, t);
}

/// Empty where the solver can run under this control.
inline std::string_view why_not(const Row& row, const Control& control) {
  const auto* fixed = std::get_if<FixedSteps>(&control);
  if (fixed && !row.fixed_steps) return "chooses its own steps: give tolerances";
  if (fixed && fixed->compensated) return "has no compensated summation";
  if (!fixed && !row.error_control) return "has no error estimate: give a fixed number of steps";
  return "";
}

/// No step to a later time is left.
inline bool vanishes(double h, double t) {
  return !(h > std::numeric_limits<double>::epsilon() * std::abs(t)) ||
         !(h > std::numeric_limits<double>::min());
}

/// What one fixed step does to a linear homogeneous problem; only for solvers that remember nothing.
template <RunReport (*run)(const Job&)>
TransitionMatrix<double> one_step_matrix(const ErasedSystem<double>& homogeneous, double h) {
  TransitionMatrix<double> matrix;
  matrix.size = homogeneous.size;
  const Control one_step = FixedSteps{1};
  for (std::size_t j = 0; j < matrix.size; ++j) {
    std::vector<double> y(matrix.size, 0.0);
    y[j] = 1;
    const auto report = run(Job{homogeneous, nullptr, one_step, 0, h, y, nullptr});
    if (report.status != RunStatus::reached_end) matrix.solved = false;
    matrix.columns.insert(matrix.columns.end(), y.begin(), y.end());
  }
  return matrix;
}

/// `run` is one plain function per solver; `remembers` says that a step depends on the steps before it.
template <RunReport (*run)(const Job&)>
AnyMethod make_contestant(std::string_view provider, const Row& row, bool remembers,
                          std::function<Theory()> theory) {
  AnyMethod any;
  any.id = row.id, any.kind = row.kind, any.source = row.source, any.provider = provider;
  any.order = row.order, any.embedded_order = row.embedded_order, any.needs = row.needs;
  any.takes_fixed_steps = row.fixed_steps, any.takes_error_control = row.error_control;
  any.multistep = row.multistep, any.note = row.note;
  any.theory = std::move(theory);
  auto& runs = std::get<MethodRuns<double>>(any.by_type);
  runs.solve = [](const ErasedSystem<double>& system, const Control& control, double t0, double t1,
                  std::vector<double>& y) {
    return run(Job{system, nullptr, control, t0, t1, y, nullptr});
  };
  runs.solve_traced = [](const ErasedSystem<double>& counted, const ErasedSystem<double>& bare,
                         const Control& control, double t0, double t1, std::vector<double>& y,
                         Trace<double>& trace) {
    return run(Job{counted, &bare, control, t0, t1, y, &trace});
  };
  if (row.fixed_steps && !remembers) runs.transition = one_step_matrix<run>;
  return any;
}

inline Theory no_theory(std::string_view why) {
  Theory theory;
  theory.blank_reason = why;
  return theory;
}

}  // namespace odemark::contestant
