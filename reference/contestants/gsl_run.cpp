// Drives gsl_odeiv2: callbacks that cannot throw, steps one at a time, its error codes as statuses.
#include "reference/contestants/gsl_run.hpp"

#include <gsl/gsl_errno.h>

#include <memory>
#include <mutex>
#include <optional>

namespace odemark::contestant {
namespace {

struct FreeDriver {
  void operator()(gsl_odeiv2_driver* driver) const { gsl_odeiv2_driver_free(driver); }
};

/// GSL aborts the process on an error unless told otherwise.
void keep_gsl_quiet() {
  static std::once_flag once;
  std::call_once(once, [] { gsl_set_error_handler_off(); });
}

struct GslProblem {
  GslProblem(const ErasedSystem<double>& system, const GslRow& row)
      : callee(system),
        columns(row.needs & Ability::jacobian ? system.size * system.size : 0),
        early(row.uses_time_derivative ? system.size : 0),
        gsl{rhs, jacobian, system.size, this} {}
  GslProblem(const GslProblem&) = delete;
  GslProblem& operator=(const GslProblem&) = delete;

  static int rhs(double t, const double y[], double dydt[], void* p) {
    return static_cast<GslProblem*>(p)->callee.rhs(t, y, dydt) ? GSL_SUCCESS : GSL_EBADFUNC;
  }
  static int jacobian(double t, const double y[], double* row_major, double dfdt[], void* p) {
    auto& me = *static_cast<GslProblem*>(p);
    const std::size_t n = me.callee.size();
    if (!me.callee.jacobian(t, y, me.columns.data())) return GSL_EBADFUNC;
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j) row_major[i * n + j] = me.columns[j * n + i];
    std::fill(dfdt, dfdt + n, 0.0);
    if (me.early.empty()) return GSL_SUCCESS;
    // central difference over a thousandth of the step: beyond what the step itself resolves
    const double d =
        std::max(1e-3 * std::abs(me.step), 64 * std::numeric_limits<double>::epsilon() * std::abs(t));
    const double before = t - d, after = t + d;
    if (!me.callee.rhs(before, y, me.early.data()) || !me.callee.rhs(after, y, dfdt)) return GSL_EBADFUNC;
    for (std::size_t i = 0; i < n; ++i) dfdt[i] = (dfdt[i] - me.early[i]) / (after - before);
    return GSL_SUCCESS;
  }

  Callee callee;
  std::vector<double> columns, early;
  double step = 0;  // the step being tried
  gsl_odeiv2_system gsl;
};

/// Fixed steps have no tolerance; the implicit steppers need one for their Newton iteration all the same.
ErrorControl newton_tolerance(const std::vector<double>& y) {
  double size = 0;
  for (const double v : y) size = std::max(size, std::abs(v));
  return ErrorControl{1e-12, size > 0 && std::isfinite(size) ? 1e-12 * size : 1e-12};
}

std::unique_ptr<gsl_odeiv2_driver, FreeDriver> new_driver(const GslRow& row, const GslProblem& problem,
                                                          const ErrorControl& control, double first_step) {
  const std::vector<double> ones(problem.gsl.dimension, 1.0);
  return std::unique_ptr<gsl_odeiv2_driver, FreeDriver>(gsl_odeiv2_driver_alloc_scaled_new(
      &problem.gsl, *row.type, first_step, control.absolute_tolerance, control.relative_tolerance, 1, 0,
      control.scale ? control.scale : ones.data()));
}

/// Values inside a step: the same stepper, fresh, from the last accepted state; the run itself is not
/// touched.
class SideSteps {
 public:
  SideSteps(const GslRow& row, const Job& job, const ErrorControl& control)
      : row_(row), problem_(*job.bare, row), control_(control), between_(job.y) {}

  bool value(double t_from, const std::vector<double>& from, double h_hint, double t, double* out) {
    const double first = row_.multistep ? 1e-3 * h_hint : t - t_from;
    const auto driver = new_driver(row_, problem_, control_, first);
    if (!driver) return false;
    between_ = from;
    double now = t_from;
    problem_.step = t - t_from;
    int status = GSL_SUCCESS;
    if (row_.multistep) {
      gsl_odeiv2_driver_set_nmax(driver.get(), 10'000);
      status = gsl_odeiv2_driver_apply(driver.get(), &now, t, between_.data());
    } else {
      status = gsl_odeiv2_evolve_apply_fixed_step(driver->e, nullptr, driver->s, &problem_.gsl, &now,
                                                  t - t_from, between_.data());
    }
    problem_.callee.rethrow();
    std::copy(between_.begin(), between_.end(), out);
    return status == GSL_SUCCESS && all_finite(between_);
  }

 private:
  const GslRow& row_;
  GslProblem problem_;
  ErrorControl control_;
  std::vector<double> between_;
};

RunStatus gave_up(const GslRow& row) {
  return row.needs & Ability::jacobian ? RunStatus::newton_diverged : RunStatus::step_underflow;
}

RunReport fixed_steps(const GslRow& row, const Job& job) {
  GslProblem problem(job.system, row);
  const ErrorControl newton = newton_tolerance(job.y);
  const double h = job.step_size();
  const auto driver = new_driver(row, problem, newton, h);
  RunReport report;
  if (!driver) return ended(report, RunStatus::solver_failed, job.t0, "GSL refused to set up the stepper");
  Recorder recorder(job);
  std::optional<SideSteps> side;
  if (recorder.traced()) side.emplace(row, job, newton);
  std::vector<double> before(job.y);
  problem.step = h;
  for (long n = 0; n < job.fixed()->count; ++n) {
    double t = job.time_of(n);
    const double t_next = job.time_of(n + 1);
    if (recorder.traced()) before = job.y;
    const int status =
        gsl_odeiv2_evolve_apply_fixed_step(driver->e, nullptr, driver->s, &problem.gsl, &t, h, job.y.data());
    problem.callee.rethrow();
    if (status != GSL_SUCCESS)
      return ended(report, all_finite(job.y) ? gave_up(row) : RunStatus::not_finite, job.time_of(n));
    ++report.accepted;
    const auto between = [&](double time, double* out) {
      return side->value(job.time_of(n), before, h, time, out);
    };
    if (!recorder.accepted(t_next, job.y.data(), between))
      return ended(report, RunStatus::time_limit, t_next);
  }
  return ended(report, job.y, job.t1);
}

RunReport error_controlled(const GslRow& row, const Job& job) {
  const ErrorControl& control = *job.adaptive();
  GslProblem problem(job.system, row);
  double h = first_step(job.system, control, row.embedded_order > 0 ? row.embedded_order + 1 : 5, job.t0,
                        job.t1, job.y);
  const auto driver = new_driver(row, problem, control, h);
  RunReport report;
  if (!driver) return ended(report, RunStatus::solver_failed, job.t0, "GSL refused to set up the stepper");
  Recorder recorder(job);
  std::optional<SideSteps> side;
  if (recorder.traced()) side.emplace(row, job, control);
  std::vector<double> before(job.y);
  double t = job.t0;
  while (t < job.t1) {
    if (report.accepted + report.rejected >= control.step_limit)
      return ended(report, RunStatus::step_limit, t);
    const double t_before = t, h_before = h;
    before = job.y;
    problem.step = h;
    const int status =
        gsl_odeiv2_evolve_apply(driver->e, driver->c, driver->s, &problem.gsl, &t, job.t1, &h, job.y.data());
    report.rejected = long(driver->e->failed_steps);
    problem.callee.rethrow();
    if (status != GSL_SUCCESS) {
      // an untouched t says that the stepper itself failed, a moved one that its error could not be met
      const bool stepper_failed = t == t_before;
      job.y = before;
      ++report.rejected;
      return ended(report, stepper_failed ? gave_up(row) : RunStatus::step_underflow, t_before);
    }
    if (!all_finite(job.y)) return ended(report, RunStatus::not_finite, t);
    ++report.accepted;
    const auto between = [&](double time, double* out) {
      return side->value(t_before, before, std::min(h_before, t - t_before), time, out);
    };
    if (!recorder.accepted(t, job.y.data(), between)) return ended(report, RunStatus::time_limit, t);
    if (t < job.t1 && (t == t_before || vanishes(h, t))) return ended(report, RunStatus::step_underflow, t);
  }
  return ended(report, job.y, t);
}

}  // namespace

RunReport run_gsl(const GslRow& row, const Job& job) {
  keep_gsl_quiet();
  if (const auto reason = why_not(row, job.control); !reason.empty())
    return ended({}, RunStatus::not_applicable, job.t0, reason);
  return job.fixed() ? fixed_steps(row, job) : error_controlled(row, job);
}

}  // namespace odemark::contestant
