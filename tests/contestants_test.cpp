// The third-party solvers behind the suite's interface: accuracy, order, theory, grids, counts, and their
// defects.
#include <gmock/gmock.h>

#include <set>

#include "reference/library_checks.hpp"
#include "tests/support/contestant_problems.hpp"

#ifdef ODEMARK_HAS_ODEINT
#include "reference/contestants/odeint_static.hpp"
#endif
#ifdef ODEMARK_HAS_SUNDIALS
#include "reference/contestants/sundials_handles.hpp"
#endif

namespace odemark::contestants_test {
namespace {

using namespace probe;
using testing::Each;

double distance(const std::vector<double>& y, const double* exact) {
  return std::hypot(y[0] - exact[0], y[1] - exact[1]);
}

template <class Family>
void reaches_the_end(const Family& family, bool fixed) {
  const Erased system = erase<double>(family);
  std::vector<double> start(2);
  family.initial(start.data());
  double exact[2];
  family.exact(family.t_end, start.data(), exact);
  for_each_contestant(system, fixed, [&](const AnyMethod& m) {
    const Control control = fixed ? Control(FixedSteps{2000}) : Control(ErrorControl{1e-6, 1e-6});
    const End end = solve(m, system, control, family.t_end, start);
    EXPECT_EQ(end.report.status, RunStatus::reached_end) << end.report.reason;
    EXPECT_EQ(end.report.t_reached, family.t_end);
    // first order: error about t h / 2; under error control a few hundred tolerances, more at first order
    const bool first_order =
        m.order == 1 || (m.id == "odeint_velocity_verlet" && family.force_depends_on_velocity);
    const double allowed = fixed ? (first_order ? 0.03 : 2e-4) : first_order ? 1e-2 : 1e-3;
    EXPECT_LT(distance(end.y, exact), allowed);
    EXPECT_GT(end.work.rhs + end.work.acceleration, 0);
    if (fixed) {
      EXPECT_EQ(end.report.accepted, 2000);
      EXPECT_EQ(end.report.rejected, 0);
    } else {
      EXPECT_GT(end.report.accepted, 5);
      EXPECT_LT(end.report.accepted, 30000);
    }
    EXPECT_EQ(end.work.jacobian > 0, bool(m.needs & Ability::jacobian) || end.report.newton.lu > 0);
  });
}
TEST(contestants, reach_the_end_in_fixed_steps) {
  reaches_the_end(Oscillator<>{}, true);
  reaches_the_end(DampedSpring<>{}, true);
}
TEST(contestants, reach_the_end_within_tolerance) {
  reaches_the_end(Oscillator<>{}, false);
  reaches_the_end(DampedSpring<>{}, false);
}

TEST(contestants, tighter_tolerances_give_smaller_errors) {
  for_each_contestant(driven(), false, [](const AnyMethod& m) {
    const double exact[2] = {std::sin(3.0), std::cos(3.0)};
    const auto error = [&](double tolerance) {
      return distance(solve(m, driven(), ErrorControl{tolerance, tolerance}, 3, {0, 1}).y, exact);
    };
    EXPECT_LT(error(1e-7), 0.1 * error(1e-4) + 1e-9);
  });
}

/// Between two step sizes where the method is past its first steps and not yet at rounding.
double observed_order(const AnyMethod& m, const Erased& system) {
  const long steps = m.order >= 8 ? 5 : m.order == 5 ? 100 : 200;
  const double end = m.order >= 8 ? 2 : 3;
  const auto error = [&](long count) {
    const double exact[2] = {std::sin(end), std::cos(end)};
    return distance(solve(m, system, FixedSteps{count}, end, {0, 1}).y, exact);
  };
  return std::log2(error(steps) / error(2 * steps));
}

TEST(contestants, fixed_steps_have_the_claimed_order_and_the_exceptions_are_named) {
  std::set<std::string_view> known;
  for (const auto& check : library_checks())
    if (check.applies && (check.id == "erkstep_order_loss" || check.id == "odeint_rosenbrock_time"))
      known.insert(check.affects.begin(), check.affects.end());
  for_each_contestant(driven(), true, [&](const AnyMethod& m) {
    const double order = observed_order(m, driven());
    RecordProperty(std::string(m.id), std::to_string(order));
    // the note of the last says so: the force here depends on velocity
    const bool loses = known.count(m.id) > 0, lags = m.id == "odeint_velocity_verlet";
    EXPECT_NEAR(order, lags ? 1 : m.id == "arkode_erk_rk4" && loses ? 3 : loses ? 1 : m.order, 0.2);
  });
  // without a velocity in the force, Verlet is Verlet
  const Oscillator<> oscillator;
  const Erased spring = erase<double>(oscillator);
  for_each_contestant(spring, true, [&](const AnyMethod& m) {
    if (m.id == "odeint_velocity_verlet") {
      EXPECT_NEAR(observed_order(m, spring), 2, 0.2);
    }
  });
}

TEST(contestants, theory_is_what_one_step_does) {
  Erased decay;
  decay.size = 1, decay.abilities = Ability::jacobian | Ability::moderate_size;
  decay.rhs_call = [](const void*, double, const double* y, double* d) { d[0] = -0.7 * y[0]; };
  decay.jacobian_call = [](const void*, double, const double*, double* j) { j[0] = -0.7; };
  const auto value = [](const std::vector<Coefficient>& polynomial, Coefficient z) {
    Coefficient sum = 0;
    for (auto i = polynomial.rbegin(); i != polynomial.rend(); ++i) sum = sum * z + *i;
    return sum;
  };
  int known = 0;
  for (const auto& m : contestants()) {
    SCOPED_TRACE(m.id);
    const Theory theory = m.theory();
    EXPECT_EQ(theory.numerator.empty(), !theory.blank_reason.empty());
    EXPECT_EQ(theory.numerator.empty(), m.runs<double>().transition == nullptr);
    if (theory.numerator.empty()) continue;
    ++known;
    const End end = solve(m, decay, FixedSteps{1}, 1, {1});
    EXPECT_NEAR(end.y[0], double(value(theory.numerator, -0.7L) / value(theory.denominator, -0.7L)), 1e-11);
    const auto matrix = m.runs<double>().transition(decay, 1);
    ASSERT_EQ(matrix.columns.size(), 1u);
    EXPECT_TRUE(matrix.solved);
    EXPECT_EQ(matrix.columns[0], end.y[0]);
  }
  EXPECT_TRUE(known >= 10 || contestants().size() < 20);
}

TEST(contestants, grid_values_are_as_good_as_the_run_and_leave_it_alone) {
  for (const bool fixed : {true, false})
    for_each_contestant(driven(), fixed, [&](const AnyMethod& m) {
      const Control control = fixed ? Control(FixedSteps{300}) : Control(ErrorControl{1e-6, 1e-6});
      Trace<double> trace;
      for (int i = 1; i <= 61; ++i) trace.grid.push_back(i == 61 ? 3.0 : 0.0487 * i);
      const End traced = solve(m, driven(), control, 3, {0, 1}, &trace);
      const End plain = solve(m, driven(), control, 3, {0, 1});
      EXPECT_EQ(traced.y, plain.y);
      EXPECT_EQ(traced.report.accepted, plain.report.accepted);
      EXPECT_EQ(traced.work.rhs, plain.work.rhs);
      EXPECT_EQ(traced.work.jacobian, plain.work.jacobian);
      ASSERT_EQ(trace.samples.size(), 2 * trace.grid.size());
      const double allowed = fixed ? (m.order == 1 || m.id == "odeint_velocity_verlet" ? 0.05 : 1e-3) : 2e-3;
      for (std::size_t i = 0; i < trace.grid.size(); ++i) {
        const double exact[2] = {std::sin(trace.grid[i]), std::cos(trace.grid[i])};
        EXPECT_LT(distance({trace.samples[2 * i], trace.samples[2 * i + 1]}, exact), allowed)
            << trace.grid[i];
      }
    });
}

TEST(contestants, scales_are_absolute_tolerances) {
  // a component whose natural size is 1e6: with its scale, 1e-6 of it is enough
  const double scale[2] = {1e6, 1e6};
  for_each_contestant(driven(), false, [&](const AnyMethod& m) {
    ErrorControl tight{1e-10, 1e-6}, scaled{1e-10, 1e-12};
    scaled.scale = scale;
    const End a = solve(m, driven(), tight, 3, {0, 1}), b = solve(m, driven(), scaled, 3, {0, 1});
    EXPECT_EQ(a.report.status, RunStatus::reached_end);
    EXPECT_NEAR(double(a.report.accepted), double(b.report.accepted), 0.05 * double(a.report.accepted) + 2);
  });
}

TEST(contestants, explicit_methods_cost_what_their_tables_say) {
  const std::vector<std::pair<std::string_view, long>> evaluations{{"odeint_euler", 1},
                                                                   {"odeint_runge_kutta4", 4},
                                                                   {"odeint_cash_karp54", 6},
                                                                   {"odeint_fehlberg78", 13},
                                                                   {"odeint_rosenbrock4", 8},
                                                                   {"arkode_ark_rk4", 4},
                                                                   {"gsl_rk4", 12}};
  for_each_contestant(driven(), true, [&](const AnyMethod& m) {
    for (const auto& [id, count] : evaluations)
      if (m.id == id) {
        EXPECT_NEAR(double(solve(m, driven(), FixedSteps{100}, 3, {0, 1}).work.rhs), 100 * double(count), 2);
      }
  });
}

TEST(contestants, describe_themselves) {
  std::set<std::string_view> ids;
  for (const auto& m : contestants()) {
    SCOPED_TRACE(m.id);
    EXPECT_TRUE(ids.insert(m.id).second);
    EXPECT_EQ(m.id.substr(0, m.provider == "sundials" ? 2 : 3),
              m.provider == "sundials" ? m.id.substr(0, 2) : m.provider.substr(0, 3));
    EXPECT_FALSE(m.source.empty());
    EXPECT_FALSE(m.note.empty());
    EXPECT_GE(m.order, 1);
    EXPECT_TRUE(m.takes_fixed_steps || m.takes_error_control);
    EXPECT_EQ(m.runs<float>().solve, nullptr);
    EXPECT_EQ(m.runs<long double>().solve, nullptr);
  }
  for (const auto& check : library_checks()) {
    SCOPED_TRACE(check.id);
    EXPECT_FALSE(check.measured.empty());
    EXPECT_FALSE(check.footnote.empty());
    for (const auto id : check.affects) EXPECT_EQ(ids.count(id), 1u) << id;
  }
  for (const auto& provider : contestant_providers()) EXPECT_FALSE(provider.version.empty());
}

#ifdef ODEMARK_HAS_ODEINT
TEST(contestants, odeint_steps_alike_on_arrays_and_vectors) {
  const Oscillator<> oscillator;
  const Erased system = erase<double>(oscillator);
  const auto rhs = [](const std::array<double, 2>& y, std::array<double, 2>& d, double) {
    d[0] = y[1], d[1] = -y[0];
  };
  const auto alike = [&]<class Stepper>(std::string_view id, Stepper) {
    std::array<double, 2> y{0, 1};
    odeint_fixed_steps<Stepper>(rhs, y, 0, 0.01, 100);
    for_each_contestant(system, true, [&](const AnyMethod& m) {
      if (m.id != id) return;
      const End end = solve(m, system, FixedSteps{100}, 1, {0, 1});
      EXPECT_NEAR(end.y[0], y[0], 1e-14);
      EXPECT_NEAR(end.y[1], y[1], 1e-14);
    });
  };
  using Arrays = OdeintStatic<2>;
  using Ranges = OdeintStatic<2, boost::numeric::odeint::range_algebra>;
  alike("odeint_euler", Arrays::Euler{});
  alike("odeint_runge_kutta4", Arrays::RungeKutta4{});
  alike("odeint_runge_kutta4", Arrays::RungeKutta4Classic{});
  alike("odeint_runge_kutta4", Ranges::RungeKutta4{});
  alike("odeint_dopri5", Arrays::DormandPrince5{});
}
#endif

#ifdef ODEMARK_HAS_SUNDIALS
TEST(contestants, counters_are_the_solvers_own) {
  using namespace contestant;
  const Erased system = driven();
  SundialsContext context;
  SundialsProblem problem(system);
  std::vector<double> start{0, 1}, absolute{1e-6, 1e-6};
  const auto y = context.view(start), tolerances = context.view(absolute);
  void* cvode = CVodeCreate(CV_BDF, context);
  CVodeInit(cvode, SundialsProblem::rhs, 0, y.get());
  CVodeSVtolerances(cvode, 1e-6, tolerances.get());
  CVodeSetUserData(cvode, &problem);
  const OwnedMatrix matrix(SUNDenseMatrix(2, 2, context));
  const OwnedLinearSolver linear(SUNLinSol_Dense(y.get(), matrix.get(), context));
  CVodeSetLinearSolver(cvode, linear.get(), matrix.get());
  CVodeSetJacFn(cvode, SundialsProblem::jacobian);
  CVodeSetStopTime(cvode, 3);
  double t = 0;
  ASSERT_GE(CVode(cvode, 3, y.get(), &t, CV_NORMAL), 0);
  long steps = 0, evaluations = 0, setups = 0, iterations = 0, jacobians = 0;
  CVodeGetNumSteps(cvode, &steps);
  CVodeGetNumRhsEvals(cvode, &evaluations);
  CVodeGetNumLinSolvSetups(cvode, &setups);
  CVodeGetNumNonlinSolvIters(cvode, &iterations);
  CVodeGetNumJacEvals(cvode, &jacobians);
  CVodeFree(&cvode);
  for_each_contestant(system, false, [&](const AnyMethod& m) {
    if (m.id != "cvode_bdf") return;
    const End end = solve(m, system, ErrorControl{1e-6, 1e-6}, 3, {0, 1});
    EXPECT_EQ(end.y, start);
    EXPECT_EQ(end.report.accepted, steps);
    EXPECT_EQ(end.work.rhs, evaluations);
    EXPECT_EQ(end.work.jacobian, jacobians);
    EXPECT_EQ(end.report.newton.lu, setups);
    EXPECT_EQ(end.report.newton.newton, iterations);
  });
}
#endif

}  // namespace
}  // namespace odemark::contestants_test
