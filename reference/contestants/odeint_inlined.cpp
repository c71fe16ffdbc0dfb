// odeint's controlled steppers on std::array with the right-hand side inlined: its fast path, for the scenes
// where our own methods are compiled that way too.
#include <boost/numeric/odeint/algebra/array_algebra.hpp>
#include <boost/numeric/odeint/stepper/controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_cash_karp54.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>

#include "problems/kepler.hpp"
#include "problems/lorenz63.hpp"
#include "problems/pleiades.hpp"
#include "reference/contestants/odeint_error_test.hpp"
#include "reference/contestants/odeint_loops.hpp"
#include "reference/contestants/odeint_methods.hpp"

namespace odemark::contestant {
namespace {

namespace odeint = boost::numeric::odeint;

template <class F>
struct Inlined {
  using State = std::array<double, F::size>;
  F family;
  void rhs(double t, const State& y, State& dydt) const { family.rhs(t, y.data(), dydt.data()); }
};

template <class F, class Stepper, int error_order>
RunReport solve(const void* values, const Control& any_control, double t0, double t1, double* y_in_out) {
  using State = std::array<double, F::size>;
  const Inlined<F> system{*static_cast<const F*>(values)};
  const ErrorControl& control = std::get<ErrorControl>(any_control);
  State y;
  std::copy_n(y_in_out, F::size, y.begin());
  odeint::controlled_runge_kutta<Stepper, OdeintErrorTest> stepper{OdeintErrorTest(control)};
  const auto rhs = [&](const State& state, State& slope, double t) { system.rhs(t, state, slope); };
  const auto try_step = [&](double& t, double& h) {
    return stepper.try_step(rhs, y, t, h) == odeint::success;
  };
  RunReport report = odeint_steps(
      control, first_step(system, control, error_order, t0, t1, y), t0, t1, try_step,
      [](double, double) { return true; }, [&] { return all_finite(y); });
  std::copy_n(y.begin(), F::size, y_in_out);
  return report;
}

template <class F>
void add(std::vector<InlinedContestant>& runs) {
  using State = std::array<double, F::size>;
  using Algebra = odeint::array_algebra;
  runs.push_back({F::id, "odeint_cash_karp54",
                  solve<F, odeint::runge_kutta_cash_karp54<State, double, State, double, Algebra>, 5>});
  runs.push_back({F::id, "odeint_dopri5",
                  solve<F, odeint::runge_kutta_dopri5<State, double, State, double, Algebra>, 5>});
  runs.push_back({F::id, "odeint_fehlberg78",
                  solve<F, odeint::runge_kutta_fehlberg78<State, double, State, double, Algebra>, 8>});
}

}  // namespace

void add_odeint_inlined(std::vector<InlinedContestant>& runs) {
  add<Lorenz63<double>>(runs);
  add<Kepler<double>>(runs);
  add<Pleiades<double>>(runs);
}

}  // namespace odemark::contestant
