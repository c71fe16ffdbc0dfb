// odeint's Rosenbrock method as a contestant: time derivative, scales, side steps.
#include "reference/contestants/odeint_loops.hpp"
#include "reference/contestants/odeint_methods.hpp"
#include "reference/contestants/odeint_rosenbrock_stepper.hpp"
#include "reference/contestants/stability_probe.hpp"

namespace odemark::contestant {
namespace {

using State = std::vector<double>;

constexpr Row row{
    "odeint_rosenbrock4",
    "Rosenbrock",
    "E. Hairer, G. Wanner, Solving Ordinary Differential Equations II, 2nd ed. (Springer, 1996), IV.7 "
    "(RODAS)",
    4,
    3,
    Ability::jacobian | Ability::moderate_size,
    true,
    true,
    false,
    "Boost 1.74 has the fourth coefficient of df/dt with the wrong sign: order 1 where f depends on time, 4 "
    "where "
    "it does not. uBLAS, compiled without its run-time checks. df/dt by a central difference: two "
    "evaluations per "
    "step. Error test: root mean square in units of each component's scale where scales are given "
    "(two operations per component and evaluation). Grid values: side steps of the same stepper."};

/// The problem as rosenbrock4 calls it, with df/dt by a central difference.
class Problem {
 public:
  Problem(const ErasedSystem<double>& system, const double* scale)
      : system_(system, scale), columns_(system.size * system.size), early_(system.size) {}

  void jacobian(double t, const double* z, double* row_major, double* dfdt) {
    const std::size_t n = system_.size();
    std::fill(columns_.begin(), columns_.end(), 0.0);
    system_.jacobian(t, z, columns_.data());
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j)
        row_major[i * n + j] = columns_[j * n + i] * system_.size_of(j) / system_.size_of(i);
    // over a thousandth of the step: beyond what the step itself resolves
    const double d =
        std::max(1e-3 * std::abs(step), 64 * std::numeric_limits<double>::epsilon() * std::abs(t));
    const double before = t - d, after = t + d;
    system_.rhs(before, z, early_.data()), system_.rhs(after, z, dfdt);
    for (std::size_t i = 0; i < n; ++i) dfdt[i] = (dfdt[i] - early_[i]) / (after - before);
  }
  RosenbrockProblem callbacks() {
    return {this,
            [](void* p, double t, const double* z, double* dzdt) {
              static_cast<Problem*>(p)->system_.rhs(t, z, dzdt);
            },
            [](void* p, double t, const double* z, double* row_major, double* dfdt) {
              static_cast<Problem*>(p)->jacobian(t, z, row_major, dfdt);
            }};
  }
  const InUnits& units() const { return system_; }

  double step = 0;  // the step being tried

 private:
  InUnits system_;
  State columns_, early_;
};

RunReport run(const Job& job) {
  if (const auto reason = why_not(row, job.control); !reason.empty())
    return ended({}, RunStatus::not_applicable, job.t0, reason);
  const ErrorControl* control = job.adaptive();
  const double* scale = control ? control->scale : nullptr;
  Problem problem(job.system, scale), side_problem(job.bare ? *job.bare : job.system, scale);
  const auto calls = problem.callbacks(), side_calls = side_problem.callbacks();
  State z(job.y);
  problem.units().into(z);
  const auto move_to = [&](const State& from) {
    job.y = from;
    problem.units().back(job.y);
  };
  const auto between = [&](double t_old, const State& y_old, double t, double* out) {
    RosenbrockStepper fresh(job.y.size(), 1, 1);
    State inside(y_old);
    side_problem.units().into(inside);
    side_problem.step = t - t_old;
    fresh.step(side_calls, t_old, t - t_old, inside.data());
    side_problem.units().back(inside);
    std::copy(inside.begin(), inside.end(), out);
    return all_finite(inside);
  };
  RunReport report;
  if (control) {
    RosenbrockStepper stepper(z.size(), control->absolute_tolerance, control->relative_tolerance);
    const auto try_step = [&](double& t, double& h) {
      problem.step = h;
      if (!stepper.try_step(calls, t, h, z.data())) return false;
      move_to(z);
      return true;
    };
    report = odeint_controlled(
        job, first_step(job.system, *control, row.embedded_order + 1, job.t0, job.t1, job.y), try_step,
        between);
  } else {
    RosenbrockStepper stepper(z.size(), 1, 1);
    const auto step = [&](double t, double h) {
      problem.step = h;
      stepper.step(calls, t, h, z.data());
      move_to(z);
    };
    report = odeint_fixed(job, step, between);
  }
  report.newton.lu = report.accepted + report.rejected;
  return report;
}

}  // namespace

void add_odeint_rosenbrock(std::vector<AnyMethod>& methods) {
  // six stages with the same gamma = 1/4 on the diagonal
  methods.push_back(make_contestant<run>("odeint", row, false, [] {
    return probed_theory<run>(6, power({1, -0.25L}, 6));
  }));
}

}  // namespace odemark::contestant
