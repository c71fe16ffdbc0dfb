// CVODE: variable-order Adams and BDF, driven in one-step mode.
#include "reference/contestants/sundials_handles.hpp"
#include "reference/contestants/sundials_methods.hpp"

namespace odemark::contestant {
namespace {

struct FreeCvode {
  void operator()(void* memory) const { CVodeFree(&memory); }
};

constexpr std::string_view source = "A. C. Hindmarsh et al., ACM Trans. Math. Softw. 31 (2005) 363-396";

constexpr Row adams{
    "cvode_adams",
    "multistep",
    source,
    12,
    0,
    0,
    false,
    true,
    true,
    "Adams-Moulton of orders 1 to 12, functional iteration. Grid values: its own interpolant."};
constexpr Row bdf{"cvode_bdf",
                  "multistep",
                  source,
                  5,
                  0,
                  0,
                  false,
                  true,
                  true,
                  "BDF of orders 1 to 5, Newton with a dense or banded matrix, the problem's Jacobian where "
                  "it has one, else difference "
                  "quotients (counted as rhs). Grid values: its own interpolant."};

template <const Row& row>
RunReport run(const Job& job) {
  constexpr bool stiff = &row == &bdf;
  if (const auto reason = why_not(row, job.control); !reason.empty())
    return ended({}, RunStatus::not_applicable, job.t0, reason);
  if (const auto reason = SundialsNewton::obstacle(job.system); stiff && !reason.empty())
    return ended({}, RunStatus::not_applicable, job.t0, reason);
  const ErrorControl& control = *job.adaptive();
  const std::size_t size = job.system.size;
  SundialsContext context;
  SundialsProblem problem(job.system);
  auto absolute = absolute_tolerances(control, size);
  const auto y = context.view(job.y), tolerances = context.view(absolute);
  SundialsNewton newton;
  OwnedNonlinearSolver iteration;
  const std::unique_ptr<void, FreeCvode> owner(CVodeCreate(stiff ? CV_BDF : CV_ADAMS, context));
  void* const cvode = owner.get();
  RunReport report;
  if (!cvode || !y || !tolerances) return ended(report, RunStatus::solver_failed, job.t0, "no memory");

  int flag = 0;
  const auto set = [&flag](int result) { flag = flag < 0 ? flag : result; };
#if SUNDIALS_VERSION_MAJOR < 7
  set(CVodeSetErrHandlerFn(cvode, say_nothing, nullptr));
#endif
  set(CVodeInit(cvode, SundialsProblem::rhs, job.t0, y.get()));
  set(CVodeSVtolerances(cvode, control.relative_tolerance, tolerances.get()));
  set(CVodeSetUserData(cvode, &problem));
  set(CVodeSetStopTime(cvode, job.t1));
  if (control.first_step > 0) set(CVodeSetInitStep(cvode, control.first_step));
  if constexpr (stiff) {
    newton.set_up(problem, y.get(), context);
    set(CVodeSetLinearSolver(cvode, newton.linear.get(), newton.matrix.get()));
    if (newton.jacobian) set(CVodeSetJacFn(cvode, newton.jacobian));
  } else {
    iteration.reset(SUNNonlinSol_FixedPoint(y.get(), 0, context));
    set(CVodeSetNonlinearSolver(cvode, iteration.get()));
  }
  if (flag < 0) return gave_up(report, flag, job.y, job.t0);

  Recorder recorder(job);
  std::vector<double> inside(size);
  const auto inside_view = context.view(inside);
  const auto between = [&](double t, double* out) {
    if (CVodeGetDky(cvode, t, 0, inside_view.get()) < 0) return false;
    std::copy(inside.begin(), inside.end(), out);
    return true;
  };
  const auto finish = [&](RunStatus status, double t, std::string_view reason = "") {
    if constexpr (stiff) {
      CVodeGetNumLinSolvSetups(cvode, &report.newton.lu);
      CVodeGetNumNonlinSolvIters(cvode, &report.newton.newton);
    }
    return ended(report, status, t, reason);
  };
  double t = job.t0;
  while (t < job.t1) {
    if (report.accepted + report.rejected >= control.step_limit) return finish(RunStatus::step_limit, t);
    const double t_before = t;
    flag = CVode(cvode, job.t1, y.get(), &t, CV_ONE_STEP);
    long error_failures = 0, solve_failures = 0;
    CVodeGetNumErrTestFails(cvode, &error_failures);
    CVodeGetNumStepSolveFails(cvode, &solve_failures);
    report.rejected = error_failures + solve_failures;
    problem.callee.rethrow();
    if (flag < 0) {
      const auto failure = gave_up(report, flag, job.y, t_before);
      return finish(failure.status, t_before, failure.reason);
    }
    if (!all_finite(job.y)) return finish(RunStatus::not_finite, t);
    ++report.accepted;
    if (!recorder.accepted(t, job.y.data(), between)) return finish(RunStatus::time_limit, t);
    // CVODE only warns when t + h == t
    if (!(t > t_before)) return finish(RunStatus::step_underflow, t);
  }
  return finish(RunStatus::reached_end, t);
}

template <const Row& row>
AnyMethod method() {
  return make_contestant<run<row>>("sundials", row, true, [] {
    return no_theory("varies its order and step: no single stability function");
  });
}

}  // namespace

void add_cvode(std::vector<AnyMethod>& methods) {
  methods.push_back(method<adams>());
  methods.push_back(method<bdf>());
}

}  // namespace odemark::contestant
