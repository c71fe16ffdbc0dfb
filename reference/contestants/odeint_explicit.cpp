// odeint's explicit Runge-Kutta steppers.
#include <boost/numeric/odeint/stepper/controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/euler.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta4.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_cash_karp54.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>

#include "reference/contestants/odeint_error_test.hpp"
#include "reference/contestants/odeint_loops.hpp"
#include "reference/contestants/odeint_methods.hpp"
#include "reference/contestants/stability_probe.hpp"

namespace odemark::contestant {
namespace {

namespace odeint = boost::numeric::odeint;
using State = std::vector<double>;

#define ODEMARK_ODEINT_GRID "Grid values: side steps of the same stepper. "
#define ODEMARK_ODEINT_TEST                                                                                \
  "odeint's own step adjustment, with the suite's error norm in place of its worst component (weights at " \
  "the start of the step); NaN is rejected. "

constexpr Row euler{"odeint_euler",
                    "explicit Runge-Kutta",
                    "L. Euler, Institutiones calculi integralis I (1768)",
                    1,
                    0,
                    0,
                    true,
                    false,
                    false,
                    ODEMARK_ODEINT_GRID};
constexpr Row rk4{"odeint_runge_kutta4",
                  "explicit Runge-Kutta",
                  "W. Kutta, Z. Math. Phys. 46 (1901) 435-453",
                  4,
                  0,
                  0,
                  true,
                  false,
                  false,
                  ODEMARK_ODEINT_GRID};
constexpr Row ck54{"odeint_cash_karp54",
                   "explicit Runge-Kutta",
                   "J. R. Cash, A. H. Karp, ACM Trans. Math. Softw. 16 (1990) 201-222",
                   5,
                   4,
                   0,
                   true,
                   true,
                   false,
                   ODEMARK_ODEINT_TEST ODEMARK_ODEINT_GRID};
constexpr Row dopri5{"odeint_dopri5",
                     "explicit Runge-Kutta",
                     "J. R. Dormand, P. J. Prince, J. Comput. Appl. Math. 6 (1980) 19-26",
                     5,
                     4,
                     0,
                     true,
                     true,
                     false,
                     ODEMARK_ODEINT_TEST ODEMARK_ODEINT_GRID};
constexpr Row f78{"odeint_fehlberg78",
                  "explicit Runge-Kutta",
                  "E. Fehlberg, NASA TR R-287 (1968)",
                  8,
                  7,
                  0,
                  true,
                  true,
                  false,
                  ODEMARK_ODEINT_TEST ODEMARK_ODEINT_GRID};

template <const Row& row, class Stepper>
RunReport run(const Job& job) {
  if (const auto reason = why_not(row, job.control); !reason.empty())
    return ended({}, RunStatus::not_applicable, job.t0, reason);
  const auto rhs = [&](const State& y, State& dydt, double t) { job.system.rhs(t, y, dydt); };
  const auto side_rhs = [&](const State& y, State& dydt, double t) { job.bare->rhs(t, y, dydt); };
  State inside(job.y);
  const auto between = [&](double t_old, const State& y_old, double t, double* out) {
    Stepper fresh;
    inside = y_old;
    fresh.do_step(side_rhs, inside, t_old, t - t_old);
    std::copy(inside.begin(), inside.end(), out);
    return all_finite(inside);
  };
  if constexpr (row.error_control) {
    if (const ErrorControl* control = job.adaptive()) {
      odeint::controlled_runge_kutta<Stepper, OdeintErrorTest> stepper{OdeintErrorTest(*control)};
      const auto try_step = [&](double& t, double& h) {
        return stepper.try_step(rhs, job.y, t, h) == odeint::success;
      };
      return odeint_controlled(
          job, first_step(job.system, *control, row.embedded_order + 1, job.t0, job.t1, job.y), try_step,
          between);
    }
  }
  Stepper stepper;
  return odeint_fixed(
      job, [&](double t, double h) { stepper.do_step(rhs, job.y, t, h); }, between);
}

template <const Row& row, class Stepper, std::size_t Stages>
AnyMethod method() {
  return make_contestant<run<row, Stepper>>("odeint", row, false,
                                            [] { return probed_theory<run<row, Stepper>>(Stages); });
}

}  // namespace

void add_odeint_explicit(std::vector<AnyMethod>& methods) {
  methods.push_back(method<euler, odeint::euler<State>, 1>());
  methods.push_back(method<rk4, odeint::runge_kutta4<State>, 4>());
  methods.push_back(method<ck54, odeint::runge_kutta_cash_karp54<State>, 6>());
  methods.push_back(method<dopri5, odeint::runge_kutta_dopri5<State>, 7>());
  methods.push_back(method<f78, odeint::runge_kutta_fehlberg78<State>, 13>());
}

}  // namespace odemark::contestant
