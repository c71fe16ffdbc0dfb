// odeint's velocity Verlet stepper, and what odeint says of itself.
#include <boost/numeric/odeint/stepper/velocity_verlet.hpp>
#include <boost/version.hpp>

#include "reference/contestants/odeint_loops.hpp"
#include "reference/contestants/odeint_methods.hpp"

namespace odemark::contestant {
namespace {

using State = std::vector<double>;
using Stepper = boost::numeric::odeint::velocity_verlet<State>;

constexpr Row row{
    "odeint_velocity_verlet",
    "splitting",
    "L. Verlet, Phys. Rev. 159 (1967) 98-103",
    2,
    0,
    Ability::second_order,
    true,
    false,
    false,
    "The force at the end of a step sees the velocity of its beginning, and the next step starts with "
    "that value: order 1 where the force depends on velocity. One force evaluation per step. Grid "
    "values: side steps of a fresh stepper."};

/// odeint keeps positions and velocities apart; the problem wants them behind each other.
class Force {
 public:
  explicit Force(const ErasedSystem<double>& system) : system_(system), y_(system.size) {}
  void operator()(const State& x, const State& v, State& a, double t) {
    std::copy(x.begin(), x.end(), y_.begin());
    std::copy(v.begin(), v.end(), y_.begin() + std::ptrdiff_t(x.size()));
    system_.acceleration(t, y_, a.data());
  }

 private:
  const ErasedSystem<double>& system_;
  State y_;
};

std::pair<State, State> split(const State& y) {
  const auto middle = y.begin() + std::ptrdiff_t(y.size() / 2);
  return {State(y.begin(), middle), State(middle, y.end())};
}
void join(const std::pair<State, State>& halves, double* y) {
  std::copy(halves.second.begin(), halves.second.end(),
            std::copy(halves.first.begin(), halves.first.end(), y));
}

RunReport run(const Job& job) {
  if (const auto reason = why_not(row, job.control); !reason.empty())
    return ended({}, RunStatus::not_applicable, job.t0, reason);
  Force force(job.system), side_force(job.bare ? *job.bare : job.system);
  auto state = split(job.y);
  Stepper stepper;
  const auto step = [&](double t, double h) {
    stepper.do_step(std::ref(force), state, t, h);
    join(state, job.y.data());
  };
  const auto between = [&](double t_old, const State& y_old, double t, double* out) {
    Stepper fresh;
    auto inside = split(y_old);
    fresh.do_step(std::ref(side_force), inside, t_old, t - t_old);
    join(inside, out);
    return all_finite(inside.first) && all_finite(inside.second);
  };
  return odeint_fixed(job, step, between);
}

}  // namespace

void add_odeint_velocity_verlet(std::vector<AnyMethod>& methods) {
  methods.push_back(make_contestant<run>("odeint", row, true, [] {
    return no_theory("carries the last force over: under damping a step is no map of (x, v) alone");
  }));
}

ProviderInfo odeint_provider() {
  std::string version = BOOST_LIB_VERSION;
  std::replace(version.begin(), version.end(), '_', '.');
#if defined(__OPTIMIZE__)
  return {"odeint", "Boost " + version, "headers, compiled optimised with this binary"};
#else
  return {"odeint", "Boost " + version, "headers, compiled without optimisation with this binary"};
#endif
}

}  // namespace odemark::contestant
