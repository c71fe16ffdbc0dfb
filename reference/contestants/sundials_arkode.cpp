// Drives ARKODE in one-step mode, under fixed steps or error control.
#include "reference/contestants/sundials_arkode.hpp"

#include <array>

namespace odemark::contestant {
namespace {

static_assert(ARK_TOO_MUCH_ACC == CV_TOO_MUCH_ACC && ARK_ERR_FAILURE == CV_ERR_FAILURE &&
              ARK_CONV_FAILURE == CV_CONV_FAILURE && ARK_LSETUP_FAIL == CV_LSETUP_FAIL &&
              ARK_LSOLVE_FAIL == CV_LSOLVE_FAIL && ARK_TOO_CLOSE == CV_TOO_CLOSE &&
              ARK_ILL_INPUT == CV_ILL_INPUT);

/// ERKStep and ARKStep offer the same functions under two names.
struct Module {
  void (*free)(void**);
  int (*evolve)(void*, sunrealtype, N_Vector, sunrealtype*, int);
  int (*between)(void*, sunrealtype, int, N_Vector);
  int (*count_attempts)(void*, long*);
  int (*set_problem)(void*, void*);
  int (*set_fixed_step)(void*, sunrealtype);
  int (*set_first_step)(void*, sunrealtype);
  int (*set_stop_time)(void*, sunrealtype);
  int (*set_tolerances)(void*, sunrealtype, N_Vector);
  int (*set_weights)(void*, ARKEwtFn);
#if SUNDIALS_VERSION_MAJOR < 7
  int (*set_error_handler)(void*, ARKErrHandlerFn, void*);
#endif
};

#if SUNDIALS_VERSION_MAJOR < 7
#define ODEMARK_HANDLER(name) , name
#else
#define ODEMARK_HANDLER(name)
#endif
constexpr Module erk_step{ERKStepFree,         ERKStepEvolve,
                          ERKStepGetDky,       ERKStepGetNumStepAttempts,
                          ERKStepSetUserData,  ERKStepSetFixedStep,
                          ERKStepSetInitStep,  ERKStepSetStopTime,
                          ERKStepSVtolerances, ERKStepWFtolerances ODEMARK_HANDLER(ERKStepSetErrHandlerFn)};
constexpr Module ark_step{ARKStepFree,         ARKStepEvolve,
                          ARKStepGetDky,       ARKStepGetNumStepAttempts,
                          ARKStepSetUserData,  ARKStepSetFixedStep,
                          ARKStepSetInitStep,  ARKStepSetStopTime,
                          ARKStepSVtolerances, ARKStepWFtolerances ODEMARK_HANDLER(ARKStepSetErrHandlerFn)};
#undef ODEMARK_HANDLER

/// Fixed steps have no tolerance. Explicit ones need none; Newton iterations do: 1e-8 here, times the Newton
/// constant 1e-5.
int newton_weights(N_Vector y, N_Vector weights, void*) {
  const sunindextype n = N_VGetLength(y);
  const double *values = N_VGetArrayPointer(y), size = N_VMaxNorm(y);
  double* out = N_VGetArrayPointer(weights);
  for (sunindextype i = 0; i < n; ++i) {
    const double weight = 1e-8 * (std::abs(values[i]) + size);
    out[i] = weight > 1e-290 && std::isfinite(weight) ? 1 / weight : 1e8;
  }
  return 0;
}
/// At most 1, so that nothing small vanishes and nothing large counts as out of reach.
int plain_weights(N_Vector y, N_Vector weights, void*) {
  const sunindextype n = N_VGetLength(y);
  const double* values = N_VGetArrayPointer(y);
  double* out = N_VGetArrayPointer(weights);
  for (sunindextype i = 0; i < n; ++i) {
    const double size = std::abs(values[i]);
    out[i] = size > 1 && std::isfinite(size) ? 1 / size : 1;
  }
  return 0;
}

/// Everything that must outlive the integrator, in the order of construction.
class Arkode {
 public:
  Arkode(const ArkodeRow& row, const Job& job)
      : implicit_(row.module == ArkodeModule::ark_step_implicit),
        module_(row.module == ArkodeModule::erk_step ? erk_step : ark_step),
        problem_(job.system),
        inside_(job.system.size),
        y_(context_.view(job.y)),
        inside_view_(context_.view(inside_)),
        table_(row.table()) {
    if (!y_ || !inside_view_ || !table_) return;
    if (row.module == ArkodeModule::erk_step)
      memory_ = ERKStepCreate(SundialsProblem::rhs, job.t0, y_.get(), context_);
    else
      memory_ = implicit_ ? ARKStepCreate(nullptr, SundialsProblem::rhs, job.t0, y_.get(), context_)
                          : ARKStepCreate(SundialsProblem::rhs, nullptr, job.t0, y_.get(), context_);
    if (memory_) set_up(job);
  }
  ~Arkode() {
    if (memory_) module_.free(&memory_);
  }
  Arkode(const Arkode&) = delete;
  Arkode& operator=(const Arkode&) = delete;

  int step(double t1, double& t) { return module_.evolve(memory_, t1, y_.get(), &t, ARK_ONE_STEP); }
  bool between(const Job& job, double t, double* out) {
    int flag = -1;
    problem_.callee.with(*job.bare, [&] { flag = module_.between(memory_, t, 0, inside_view_.get()); });
    std::copy(inside_.begin(), inside_.end(), out);
    return flag >= 0;
  }
  long attempts() const {
    long count = 0;
    module_.count_attempts(memory_, &count);
    return count;
  }
  NewtonCounts newton() const {
    NewtonCounts counts;
    if (implicit_) {
      ARKStepGetNumLinSolvSetups(memory_, &counts.lu);
      ARKStepGetNumNonlinSolvIters(memory_, &counts.newton);
    }
    return counts;
  }
  void rethrow() { problem_.callee.rethrow(); }
  int set_up_flag() const { return memory_ ? flag_ : CV_MEM_FAIL; }

 private:
  void set(int result) { flag_ = flag_ < 0 ? flag_ : result; }
  void set_up(const Job& job) {
#if SUNDIALS_VERSION_MAJOR < 7
    set(module_.set_error_handler(memory_, say_nothing, nullptr));
#endif
    set(module_.set_problem(memory_, &problem_));
    if (&module_ == &erk_step)
      set(ERKStepSetTable(memory_, table_.get()));
    else
      set(ARKStepSetTables(memory_, table_->q, table_->p, implicit_ ? table_.get() : nullptr,
                           implicit_ ? nullptr : table_.get()));
    if (implicit_) set_up_newton();
    if (const ErrorControl* control = job.adaptive()) {
      absolute_ = absolute_tolerances(*control, job.system.size);
      tolerances_ = context_.view(absolute_);
      set(module_.set_tolerances(memory_, control->relative_tolerance, tolerances_.get()));
      set(module_.set_stop_time(memory_, job.t1));
      if (control->first_step > 0) set(module_.set_first_step(memory_, control->first_step));
    } else {
      set(module_.set_weights(memory_, implicit_ ? newton_weights : plain_weights));
      set(module_.set_fixed_step(memory_, job.step_size()));
    }
  }
  void set_up_newton() {
    newton_.set_up(problem_, y_.get(), context_);
    set(ARKStepSetLinearSolver(memory_, newton_.linear.get(), newton_.matrix.get()));
    if (newton_.jacobian) set(ARKStepSetJacFn(memory_, newton_.jacobian));
    set(ARKStepSetNonlinConvCoef(memory_, 1e-5));
    set(ARKStepSetMaxNonlinIters(memory_, 10));
  }

  const bool implicit_;
  const Module& module_;
  SundialsContext context_;
  SundialsProblem problem_;
  std::vector<double> inside_, absolute_;
  OwnedVector y_, inside_view_, tolerances_;
  OwnedTable table_;
  SundialsNewton newton_;
  void* memory_ = nullptr;
  int flag_ = 0;
};

}  // namespace

RunReport run_arkode(const ArkodeRow& row, const Job& job) {
  if (const auto reason = why_not(row, job.control); !reason.empty())
    return ended({}, RunStatus::not_applicable, job.t0, reason);
  if (const auto reason = SundialsNewton::obstacle(job.system);
      row.module == ArkodeModule::ark_step_implicit && !reason.empty())
    return ended({}, RunStatus::not_applicable, job.t0, reason);
  Arkode arkode(row, job);
  RunReport report;
  if (arkode.set_up_flag() < 0) return gave_up(report, arkode.set_up_flag(), job.y, job.t0);
  Recorder recorder(job);
  const auto between = [&](double t, double* out) { return arkode.between(job, t, out); };
  const auto finish = [&](RunStatus status, double t, std::string_view reason = "") {
    report.newton = arkode.newton();
    return ended(report, status, t, reason);
  };
  const FixedSteps* fixed = job.fixed();
  double t = job.t0;
  while (fixed ? report.accepted < fixed->count : t < job.t1) {
    if (!fixed && report.accepted + report.rejected >= job.adaptive()->step_limit)
      return finish(RunStatus::step_limit, t);
    const double t_before = fixed ? job.time_of(report.accepted) : t;
    const int flag = arkode.step(job.t1, t);
    arkode.rethrow();
    if (!fixed) report.rejected = arkode.attempts() - report.accepted - (flag >= 0);
    if (flag < 0) {
      const auto failure = gave_up(report, flag, job.y, t_before);
      return finish(failure.status, t_before, failure.reason);
    }
    ++report.accepted;
    if (fixed) {
      const double t_nominal = job.time_of(report.accepted);
      if (!recorder.accepted(t_nominal, job.y.data(), between))
        return finish(RunStatus::time_limit, t_nominal);
      continue;
    }
    if (!all_finite(job.y)) return finish(RunStatus::not_finite, t);
    if (!recorder.accepted(t, job.y.data(), between)) return finish(RunStatus::time_limit, t);
    // ARKODE only warns when t + h == t
    if (!(t > t_before)) return finish(RunStatus::step_underflow, t);
  }
  return finish(all_finite(job.y) ? RunStatus::reached_end : RunStatus::not_finite, job.t1);
}

ARKodeButcherTable classical_rk4_table() {
  std::array<sunrealtype, 4> c{0, 0.5, 0.5, 1}, b{1 / 6., 1 / 3., 1 / 3., 1 / 6.};
  std::array<sunrealtype, 16> a{0, 0, 0, 0, 0.5, 0, 0, 0, 0, 0.5, 0, 0, 0, 0, 1, 0};
  return ARKodeButcherTable_Create(4, 4, 0, c.data(), a.data(), b.data(), nullptr);
}

}  // namespace odemark::contestant
