// Symplectic methods conserve areas, symmetric ones can be walked back.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "integrators/methods/verlet_position_form.hpp"
#include "tests/support/geometric_methods.hpp"
#include "tests/support/runs.hpp"

namespace odemark::symplectic_test {
namespace {

double determinant(const AnyMethod& method, double h) {
  static const AnyProblem oscillator = suite_problem("oscillator");
  const auto m = method.runs<double>().transition(oscillator.system<double>(), h);
  EXPECT_EQ(m.size, 2u);
  return m.columns[0] * m.columns[3] - m.columns[1] * m.columns[2];
}

TEST(Symplectic, TheExpectedOnesAreFound) {
  for (const char* id :
       {"chapter_euler", "semi_implicit_euler", "stormer_verlet", "velocity_verlet_old_velocity", "yoshida4",
        "implicit_midpoint", "implicit_trapezoid", "position_verlet", "mclachlan_atela4", "kahan_li8",
        "average_vector_field", "gauss4", "gauss6", "gauss8", "lobatto_iiia4"})
    EXPECT_TRUE(conserves_area(suite_method(id))) << id;
  for (const char* id : {"stormer_verlet",
                         "position_verlet",
                         "yoshida4",
                         "yoshida6",
                         "yoshida8",
                         "suzuki4",
                         "suzuki_umeno8",
                         "kahan_li6",
                         "kahan_li8",
                         "pefrl",
                         "vefrl",
                         "blanes_moan4",
                         "blanes_moan6",
                         "blanes_moan_rkn4",
                         "blanes_moan_rkn6",
                         "implicit_midpoint",
                         "implicit_trapezoid",
                         "average_vector_field",
                         "gauss4",
                         "gauss6",
                         "gauss8",
                         "lobatto_iiia4",
                         "lobatto_iiib4"})
    EXPECT_TRUE(is_symmetric(suite_method(id))) << id;
  for (const char* id :
       {"mclachlan_atela2", "mclachlan_atela3", "mclachlan_atela4", "ruth3", "calvo_sanz_serna4", "rkn4"})
    EXPECT_FALSE(is_symmetric(suite_method(id))) << id;
  for (const char* id : {"implicit_midpoint", "ruth3", "calvo_sanz_serna4", "blanes_moan_rkn6"})
    EXPECT_TRUE(is_symplectic(suite_method(id))) << id;
  // symmetric and area-preserving where the problem is linear, but not symplectic
  for (const char* id : {"implicit_trapezoid", "average_vector_field", "rkn_dormand_prince86", "sdirk2"})
    EXPECT_FALSE(is_symplectic(suite_method(id))) << id;
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
      if (conserves_area(method) || method.theory().exact_on_linear_part) {  // which is exact here
        EXPECT_LT(off, 2e-15) << "h = " << h;
      } else if (method.order < 8 && h > 0.1) {
        EXPECT_GT(off, 1e-12) << "h = " << h;
      }
    }
  }
}

/// Largest entry of J' W J - W for the Jacobian J of one step, W = (0 1; -1 0): 0 where the step is
/// symplectic. Differences of fourth order in extended precision: errors are of size 1e-14.
double symplectic_defect(const AnyMethod& method, const AnyProblem& problem, long double h) {
  const std::size_t n = problem.initial.size(), half = n / 2;
  const long double delta = 1e-4L;
  std::vector<std::vector<long double>> columns(n, std::vector<long double>(n, 0));
  for (std::size_t j = 0; j < n; ++j)
    for (const auto& [at, weight] : {std::pair{-2.0L, 1.0L}, {-1.0L, -8.0L}, {1.0L, 8.0L}, {2.0L, -1.0L}}) {
      std::vector<long double> y(problem.initial.begin(), problem.initial.end());
      y[j] += at * delta;
      method.runs<long double>().solve(problem.system<long double>(), FixedSteps{1}, 0, double(h), y);
      for (std::size_t i = 0; i < n; ++i) columns[j][i] += weight * y[i] / (12 * delta);
    }
  double worst = 0;
  for (std::size_t j = 0; j < n; ++j)
    for (std::size_t k = 0; k < n; ++k) {
      long double form = k == j + half ? -1 : j == k + half ? 1 : 0;
      for (std::size_t i = 0; i < half; ++i)
        form += columns[j][i] * columns[k][i + half] - columns[j][i + half] * columns[k][i];
      if (!(std::abs(double(form)) <= worst)) worst = std::abs(double(form));
    }
  return worst;
}

TEST(Symplectic, TheJacobianOfAStepIsSymplecticForThemAndOnlyThem) {
  const auto kepler = suite_problem("kepler_e02");
  int yes = 0, no = 0;
  for (const auto& method : suite_methods()) {
    if (!is_one_step(method) || !can_run<long double>(method, kepler)) continue;
    SCOPED_TRACE(method.id);
    const double defect = symplectic_defect(method, kepler, 0.25L);
    if (is_symplectic(method)) {
      ++yes;
      EXPECT_LT(defect, 1e-11);
    } else if (method.order <= 8) {
      ++no;
      EXPECT_GT(defect, 1e-10);
    }
  }
  EXPECT_GE(yes, 25);
  EXPECT_GE(no, 20);
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
    if (!is_one_step(method) || method.theory().exact_on_linear_part || !can_run<double>(method, pendulum))
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

// --- Verlet in positions: the factors where the step changes ---

TEST(VerletPositionForm, IsVelocityVerletAtAnySequenceOfSteps) {
  const auto pendulum = suite_problem("pendulum");
  const auto system = pendulum.system<double>();
  std::vector<double> y = pendulum.initial, next = y, error = y, x = y, x_next = y, naive = y;
  StepperOf<stormer_verlet, ErasedSystem<double>> velocity(system, y);
  StepperOf<verlet_position_form, ErasedSystem<double>> position(system, y);
  velocity.start(), position.start();
  double t = 0, before = naive[0];
  for (int n = 0; n < 200; ++n) {
    const double h = 0.01 * (n % 7 == 3 ? 2 : n % 5 == 1 ? 0.5 : 1);
    EXPECT_EQ(velocity.attempt(t, y, h, next, error), StepStatus::ok);
    if (n % 3 == 0) (void)position.attempt(t, x, 3 * h, x_next, error);
    EXPECT_EQ(position.attempt(t, x, h, x_next, error), StepStatus::ok);
    velocity.accept(), position.accept();
    // what is printed in many a tutorial: right for equal steps only
    double a = 0;
    system.acceleration(t, naive, &a);
    const double moved = n == 0 ? x_next[0] : 2 * naive[0] - before + h * h * a;
    before = naive[0], naive[0] = moved;
    std::swap(y, next), std::swap(x, x_next);
    t += h;
    EXPECT_NEAR(x[0], y[0], 1e-12) << n;
    EXPECT_NEAR(x[1], y[1], 1e-11) << n;
  }
  EXPECT_GT(std::abs(naive[0] - y[0]), 0.01);
}

TEST(Symplectic, TheDriftOfRungeKuttaIsTheOneOfTheTheory) {
  // energy per period: Heun +(pi/2) z^3, RK4 -(pi/36) z^5
  const double z = 0.0625, pi = std::acos(-1.0);
  const double heun = determinant(suite_method("heun"), z), rk4 = determinant(suite_method("rk4"), z);
  EXPECT_NEAR((std::pow(heun, 2 * pi / z) - 1) / (pi / 2 * z * z * z), 1, 1e-2);
  EXPECT_NEAR((std::pow(rk4, 2 * pi / z) - 1) / (-pi / 36 * std::pow(z, 5)), 1, 1e-2);
}

}  // namespace
}  // namespace odemark::symplectic_test
