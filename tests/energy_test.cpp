// Symplectic methods do not drift in energy, and the average vector field method keeps it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "integrators/erase_method.hpp"
#include "integrators/methods/average_vector_field.hpp"
#include "tests/support/geometric_methods.hpp"
#include "tests/support/runs.hpp"

namespace odemark::energy_test {
namespace {

/// Calls look(step, relative error of the energy) after every step.
template <class Look>
void watch_energy(const AnyMethod& method, const AnyProblem& problem, long steps, Look look) {
  const auto energy = [&](const double* y) {
    const std::vector<long double> wide(y, y + problem.initial.size());
    long double all[8] = {};
    problem.invariants_call(problem.value.get(), wide.data(), all);
    return all[0];
  };
  const long double start = energy(problem.initial.data());
  Trace<double> trace;
  long n = 0;
  trace.on_step = [&](double, const double* y) {
    look(n++, double(energy(y) / start - 1));
    return true;
  };
  std::vector<double> y = problem.initial;
  method.runs<double>().solve_traced(problem.system<double>(), problem.system<double>(), FixedSteps{steps},
                                     problem.t_begin, problem.t_end, y, trace);
}

/// Largest relative energy error over each tenth of a run.
std::vector<double> energy_errors(const AnyMethod& method, const AnyProblem& problem, long steps) {
  std::vector<double> worst(10, 0.0);
  watch_energy(method, problem, steps, [&](long n, double error) {
    auto& w = worst[std::size_t(n * 10 / steps)];
    if (!(std::abs(error) <= w)) w = std::abs(error);
  });
  return worst;
}

TEST(Energy, EnergyDoesNotDriftOverTenThousandPeriods) {
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

/// How far the mean energy of the last tenth of a run is from that of the first, in units of the largest
/// error.
double secular_drift(const AnyMethod& method, const AnyProblem& problem, long steps) {
  std::vector<double> mean(10, 0);
  double largest = 0;
  watch_energy(method, problem, steps, [&](long n, double error) {
    mean[std::size_t(n * 10 / steps)] += error * 10 / static_cast<double>(steps);
    if (!(std::abs(error) <= largest)) largest = std::abs(error);
  });
  return std::abs(mean.back() - mean.front()) / largest;
}

TEST(Energy, EnergyHasNoSecularSlopeOnThePendulum) {
  // a thousand periods of 2.369 s; a step is a fortieth of one
  const auto pendulum = suite_problem("pendulum", "t_end=2369");
  const long steps = 40'000;
  for (const auto& method : suite_methods()) {
    if (!is_one_step(method) || !is_made_of_shears(method.theory().moves)) continue;
    SCOPED_TRACE(method.id);
    EXPECT_LT(secular_drift(method, pendulum, steps), 0.01);
  }
  for (const char* id : {"rk4", "dormand_prince54", "rkn4", "rkn_dormand_prince64"})
    EXPECT_GT(secular_drift(suite_method(id), pendulum, steps), 0.5) << id;
}

// --- the average vector field keeps energy, whatever its size of step ---

inline constexpr auto misprinted_average = [] {
  auto method = average_vector_field;
  method.id = "misprinted_average", method.weights[1] += 1e-4L, method.weights[3] -= 1e-4L;
  return method;
}();
inline constexpr auto unbalanced_average = [] {
  auto method = average_vector_field;
  method.id = "unbalanced_average", method.nodes[0] += 1e-6L;
  return method;
}();

double worst_energy_error(const AnyMethod& method, const AnyProblem& problem, long steps) {
  const auto errors = energy_errors(method, problem, steps);
  return *std::max_element(errors.begin(), errors.end());
}

TEST(AverageVectorField, KeepsEnergyToRoundOff) {
  const AnyMethod right = suite_method("average_vector_field"), slip = erase_method<misprinted_average>(),
                  unbalanced = erase_method<unbalanced_average>();
  EXPECT_LT(misprinted_average.energy_degree(), 10);
  EXPECT_LT(unbalanced_average.energy_degree(), 10);
  for (const auto& [id, settings, steps] : {std::tuple{"pendulum", "t_end=200", 3000L},
                                            {"pendulum_rotating", "t_end=20", 600L},
                                            {"kepler_e02", "t_end=60", 2000L},
                                            {"kepler_e06", "t_end=40", 2000L}}) {
    SCOPED_TRACE(id);
    const auto problem = suite_problem(id, settings);
    const double kept = worst_energy_error(right, problem, steps);
    EXPECT_LT(kept, 3e-14);
    for (const auto* other : {&slip, &unbalanced})
      EXPECT_GT(worst_energy_error(*other, problem, steps), 1e-11);
    for (const char* other : {"implicit_midpoint", "stormer_verlet", "implicit_trapezoid"})
      EXPECT_GT(worst_energy_error(suite_method(other), problem, steps), 1e-6) << other;
  }
}

}  // namespace
}  // namespace odemark::energy_test
