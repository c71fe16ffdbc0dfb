// odeint's Bulirsch-Stoer extrapolation.
#include <boost/numeric/odeint/stepper/bulirsch_stoer.hpp>

#include "reference/contestants/odeint_loops.hpp"
#include "reference/contestants/odeint_methods.hpp"

namespace odemark::contestant {
namespace {

using State = std::vector<double>;
using Stepper = boost::numeric::odeint::bulirsch_stoer<State>;

constexpr Row row{
    "odeint_bulirsch_stoer",
    "extrapolation",
    "R. Bulirsch, J. Stoer, Numer. Math. 8 (1966) 1-13",
    16,
    0,
    0,
    false,
    true,
    false,
    "Varies its order, 4 to 16. Error test: worst component below 1, in units of each component's scale "
    "where scales are given (two operations per component and evaluation). Grid values: side steps "
    "under the same tolerance."};

RunReport run(const Job& job) {
  if (const auto reason = why_not(row, job.control); !reason.empty())
    return ended({}, RunStatus::not_applicable, job.t0, reason);
  const ErrorControl& control = *job.adaptive();
  const auto new_stepper = [&] {
    return Stepper(control.absolute_tolerance, control.relative_tolerance, 1.0, 0.0);
  };
  const InUnits system(job.system, control.scale),
      side_system(job.bare ? *job.bare : job.system, control.scale);
  const auto rhs = [&](const State& z, State& dzdt, double t) { system.rhs(t, z.data(), dzdt.data()); };
  const auto side_rhs = [&](const State& z, State& dzdt, double t) {
    side_system.rhs(t, z.data(), dzdt.data());
  };

  State z(job.y);
  system.into(z);
  Stepper stepper = new_stepper();
  const auto try_step = [&](double& t, double& h) {
    if (stepper.try_step(rhs, z, t, h) != boost::numeric::odeint::success) return false;
    job.y = z;
    system.back(job.y);
    return true;
  };
  const auto between = [&](double t_old, const State& y_old, double t, double* out) {
    State inside(y_old);
    side_system.into(inside);
    Stepper fresh = new_stepper();
    double now = t_old, h = t - t_old;
    for (int attempt = 0; now < t; ++attempt) {
      if (attempt == 1000 || vanishes(h, now)) return false;
      h = std::min(h, t - now);
      const bool last = !(now + h < t);
      if (fresh.try_step(side_rhs, inside, now, h) == boost::numeric::odeint::success && last) now = t;
    }
    side_system.back(inside);
    std::copy(inside.begin(), inside.end(), out);
    return all_finite(inside);
  };
  return odeint_controlled(job, first_step(job.system, control, 5, job.t0, job.t1, job.y), try_step, between);
}

}  // namespace

void add_odeint_bulirsch_stoer(std::vector<AnyMethod>& methods) {
  methods.push_back(make_contestant<run>("odeint", row, false, [] {
    return no_theory("varies its order and step: no single stability function");
  }));
}

}  // namespace odemark::contestant
