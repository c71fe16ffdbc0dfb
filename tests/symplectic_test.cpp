// Symplectic methods conserve areas, symmetric ones can be walked back, and neither drifts in energy.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/runs.hpp"

namespace odemark {
namespace {

/// |R(iz)| = 1 for every z: numerator and denominator mirror each other.
bool mirrors(const Theory& theory) {
  if (theory.numerator.empty() || theory.numerator.size() != theory.denominator.size()) return false;
  for (std::size_t k = 0; k < theory.numerator.size(); ++k)
    if (std::abs(double(theory.numerator[k] - (k % 2 ? -1 : 1) * theory.denominator[k])) > 1e-15)
      return false;
  return true;
}

bool reads_the_same_backwards(const std::vector<SecondOrderMove>& moves) {
  using What = SecondOrderMove::What;
  // without a velocity in the force every kick is the same
  const auto is_drift = [](const SecondOrderMove& m) { return m.what == What::drift; };
  return !moves.empty() &&
         std::equal(moves.begin(), moves.end(), moves.rbegin(), [&](const auto& a, const auto& b) {
           return is_drift(a) == is_drift(b) && std::abs(double(a.weight - b.weight)) < 1e-15;
         });
}

bool conserves_area(const AnyMethod& m) { return !m.theory().moves.empty() || mirrors(m.theory()); }
bool is_symmetric(const AnyMethod& m) {
  return mirrors(m.theory()) || reads_the_same_backwards(m.theory().moves);
}

bool is_one_step(const AnyMethod& m) { return m.takes_fixed_steps && !m.multistep; }

double determinant(const AnyMethod& method, double h) {
  static const AnyProblem oscillator = suite_problem("oscillator");
  const auto m = method.runs<double>().transition(oscillator.system<double>(), h);
  EXPECT_EQ(m.size, 2u);
  return m.columns[0] * m.columns[3] - m.columns[1] * m.columns[2];
}

TEST(Symplectic, TheExpectedOnesAreFound) {
  for (const char* id :
       {"chapter_euler", "semi_implicit_euler", "stormer_verlet", "velocity_verlet_old_velocity", "yoshida4",
        "implicit_midpoint", "implicit_trapezoid", "gauss4", "gauss6", "gauss8", "lobatto_iiia4"})
    EXPECT_TRUE(conserves_area(suite_method(id))) << id;
  for (const char* id : {"stormer_verlet", "yoshida4", "implicit_midpoint", "implicit_trapezoid", "gauss4",
                         "gauss6", "gauss8", "lobatto_iiia4", "lobatto_iiib4"})
    EXPECT_TRUE(is_symmetric(suite_method(id))) << id;
  for (const char* id :
       {"explicit_euler", "heun", "rk4", "implicit_euler", "sdirk2", "radau_iia5", "lobatto_iiic4"})
    EXPECT_FALSE(conserves_area(suite_method(id)) || is_symmetric(suite_method(id))) << id;
  EXPECT_FALSE(is_symmetric(suite_method("semi_implicit_euler")));
}

TEST(Symplectic, TheDeterminantIsOneForThemAndOnlyThem) {
  for (const auto& method : suite_methods()) {
    if (!is_one_step(method)) continue;
    SCOPED_TRACE(method.id);
    for (const double h : {0.03125, 0.25, 0.75}) {
      const double off = std::abs(determinant(method, h) - 1);
      if (conserves_area(method) || method.id == "exponential_euler") {  // which is exact here
        EXPECT_LT(off, 2e-15) << "h = " << h;
      } else if (method.order < 8 && h > 0.1) {
        EXPECT_GT(off, 1e-12) << "h = " << h;
      }
    }
  }
}

/// The scaled distance between the start and where a step forth and a step back lead.
double step_and_back(const AnyMethod& method, const AnyProblem& problem, double h) {
  std::vector<double> y = problem.initial;
  const auto& runs = method.runs<double>();
  runs.solve(problem.system<double>(), FixedSteps{1}, 0, h, y);
  runs.solve(problem.system<double>(), FixedSteps{1}, h, 0, y);
  return scaled_gap(problem, y, problem.initial);
}

TEST(Symplectic, SymmetricMethodsStepBackToTheStart) {
  const auto pendulum = suite_problem("pendulum_rotating");
  for (const auto& method : suite_methods()) {
    if (!is_one_step(method) || method.id == "exponential_euler" || !can_run<double>(method, pendulum))
      continue;
    SCOPED_TRACE(method.id);
    const double gap = step_and_back(method, pendulum, 0.125);
    if (is_symmetric(method)) {
      EXPECT_LT(gap, 4e-15);
    } else if (method.order < 10) {
      EXPECT_GT(gap, 1e-11);
    }
  }
}

/// Largest relative energy error over each tenth of a run.
std::vector<double> energy_errors(const AnyMethod& method, const AnyProblem& problem, long steps) {
  std::vector<double> worst(10, 0.0);
  long n = 0;
  long double start = 0, now = 0;
  const auto energy = [&](const double* y) {
    const long double wide[2] = {y[0], y[1]};
    long double all[8] = {};
    problem.invariants_call(problem.value.get(), wide, all);
    return all[0];
  };
  start = energy(problem.initial.data());
  Trace<double> trace;
  trace.on_step = [&](double, const double* y) {
    now = energy(y);
    auto& w = worst[std::size_t(n++ * 10 / steps)];
    const double error = std::abs(double((now - start) / start));
    if (!(error <= w)) w = error;
    return true;
  };
  std::vector<double> y = problem.initial;
  method.runs<double>().solve_traced(problem.system<double>(), problem.system<double>(), FixedSteps{steps},
                                     problem.t_begin, problem.t_end, y, trace);
  return worst;
}

TEST(Symplectic, EnergyDoesNotDriftOverTenThousandPeriods) {
  // 2 pi s is a period of the oscillator; steps of a quarter radian, 25 a period
  const auto problem = suite_problem("oscillator", "t_end=62832");
  const long steps = 251'328;
  for (const auto& method : suite_methods()) {
    if (!is_one_step(method) || !conserves_area(method)) continue;
    SCOPED_TRACE(method.id);
    const auto errors = energy_errors(method, problem, steps);
    EXPECT_LT(errors.front(), 0.4);
    EXPECT_LT(errors.back(), errors.front() * 1.01 + 1e-10);
  }
  EXPECT_GT(energy_errors(suite_method("rk4"), problem, steps).back(), 0.5);
  const auto heun = energy_errors(suite_method("heun"), problem, steps);
  EXPECT_FALSE(heun.back() < 1e6);
}

TEST(Symplectic, TheDriftOfRungeKuttaIsTheOneOfTheTheory) {
  // energy per period: Heun +(pi/2) z^3, RK4 -(pi/36) z^5
  const double z = 0.0625, pi = std::acos(-1.0);
  const double heun = determinant(suite_method("heun"), z), rk4 = determinant(suite_method("rk4"), z);
  EXPECT_NEAR((std::pow(heun, 2 * pi / z) - 1) / (pi / 2 * z * z * z), 1, 1e-2);
  EXPECT_NEAR((std::pow(rk4, 2 * pi / z) - 1) / (-pi / 36 * std::pow(z, 5)), 1, 1e-2);
}

}  // namespace
}  // namespace odemark
