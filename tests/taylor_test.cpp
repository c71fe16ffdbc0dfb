// Taylor coefficients of known functions, and the method made of them, against formulas of its own.
#include <gtest/gtest.h>

#include <cmath>

#include "integrators/taylor_series.hpp"
#include "tests/support/probe_families.hpp"
#include "tests/support/runs.hpp"

namespace odemark::taylor_test {
namespace {

/// One equation, made of every operation a tape has. Each solution through (0, y0) is known.
template <class F>
std::vector<long double> coefficients(const F& f, long double y0, int order) {
  struct One {
    const F& f;
    void rhs(const Recorded<long double>& t, const Recorded<long double>* y,
             Recorded<long double>* dydt) const {
      dydt[0] = f(t, y[0]);
    }
  };
  const auto tape = record<long double>(One{f}, 1);
  TaylorSeries<long double> series(tape, 1, order);
  series.expand(0.0L, &y0, order);
  std::vector<long double> c;
  for (int k = 0; k <= order; ++k) c.push_back(series.coefficient(0, k));
  return c;
}

template <class Law>
void expect_law(const std::vector<long double>& c, const Law& law) {
  for (std::size_t k = 0; k < c.size(); ++k)
    EXPECT_NEAR(double(c[k] - law(int(k))), 0, 1e-17 * (1 + std::abs(double(law(int(k))))))
        << "coefficient " << k;
}

long double factorial(int k) { return k <= 1 ? 1 : static_cast<long double>(k) * factorial(k - 1); }

TEST(TaylorSeries, Exponential) {  // y' = y
  expect_law(coefficients([](auto, auto y) { return y; }, 1, 20), [](int k) { return 1 / factorial(k); });
}
TEST(TaylorSeries, Geometric) {  // y' = y^2: 1/(1-t)
  expect_law(coefficients([](auto, auto y) { return y * y; }, 1, 20), [](int) { return 1.0L; });
}
TEST(TaylorSeries, Time) {  // y' = t - y: t - 1 + 2 e^-t from 1
  expect_law(coefficients([](auto t, auto y) { return t - y; }, 1, 20), [](int k) {
    return (k == 0 ? -1.0L : k == 1 ? 1.0L : 0.0L) + 2 * (k % 2 ? -1 : 1) / factorial(k);
  });
}
TEST(TaylorSeries, SquareRoot) {  // y' = 2 sqrt(y): (1 + t)^2
  expect_law(coefficients([](auto, auto y) { return 2 * sqrt(y); }, 1, 20), [](int k) {
    return k == 0 || k == 2 ? 1.0L : k == 1 ? 2.0L : 0.0L;
  });
}
TEST(TaylorSeries, Quotient) {  // y' = y/(1 + t): 1 + t
  expect_law(coefficients([](auto t, auto y) { return y / (1 + t); }, 1, 20),
             [](int k) { return k <= 1 ? 1.0L : 0.0L; });
}
TEST(TaylorSeries, ExponentialAndLogarithm) {  // y' = exp(log y) = y
  expect_law(coefficients([](auto, auto y) { return exp(log(y)); }, 1, 20),
             [](int k) { return 1 / factorial(k); });
}
TEST(TaylorSeries, SineAndCosine) {  // y' = cos t: sin t
  expect_law(coefficients([](auto t, auto) { return cos(t); }, 0, 20),
             [](int k) { return k % 2 == 0 ? 0.0L : (k % 4 == 1 ? 1 : -1) / factorial(k); });
  expect_law(coefficients([](auto t, auto) { return sin(t); }, -1, 20),
             [](int k) { return k % 2 == 1 ? 0.0L : (k % 4 == 0 ? -1 : 1) / factorial(k); });
}
TEST(TaylorSeries, HyperbolicSineAndCosine) {  // y' = cosh t: sinh t
  expect_law(coefficients([](auto t, auto) { return cosh(t); }, 0, 20),
             [](int k) { return k % 2 == 0 ? 0.0L : 1 / factorial(k); });
  expect_law(coefficients([](auto t, auto) { return sinh(t); }, 1, 20),
             [](int k) { return k % 2 == 1 ? 0.0L : 1 / factorial(k); });
}
TEST(TaylorSeries, HyperbolicTangent) {  // y' = y tanh t: cosh t
  expect_law(coefficients([](auto t, auto y) { return y * tanh(t); }, 1, 20),
             [](int k) { return k % 2 == 1 ? 0.0L : 1 / factorial(k); });
}
TEST(TaylorSeries, ArcTangent) {  // y' = atan t: t atan t - log(1 + t^2)/2
  expect_law(coefficients([](auto t, auto) { return atan(t); }, 0, 20), [](int k) {
    return k == 0 || k % 2 == 1 ? 0.0L : (k % 4 == 2 ? 1.0L : -1.0L) / static_cast<long double>(k * (k - 1));
  });
  // of something that is no straight line: y = tan(t + 1/4) has atan y = t + 1/4
  const auto plain = coefficients([](auto, auto y) { return 1 + y * y; }, std::tan(0.25L), 20);
  expect_law(coefficients([](auto t, auto y) { return 1 + y * y + (atan(y) - t - 1 / decltype(y)(4)); },
                          std::tan(0.25L), 20),
             [&](int k) { return plain[std::size_t(k)]; });
}
TEST(TaylorSeries, Power) {
  // y' = y^3/2: (1 - t)^(-1/2)
  expect_law(coefficients([](auto, auto y) { return pow(y, decltype(y)(3)) / 2; }, 1, 20), [](int k) {
    long double binomial = 1;
    for (int j = 1; j <= k; ++j)
      binomial *= (static_cast<long double>(j) - 0.5L) / static_cast<long double>(j);
    return binomial;
  });
  // y' = 2 y^(1/2): (1 + t)^2, also where the exponent is found on the tape
  for (const long double late : {0.0L, 1.0L})
    expect_law(
        coefficients([&](auto t, auto y) { return 2 * pow(y, decltype(y)(0.5L) + late * (t - t)); }, 1, 20),
        [](int k) { return k == 0 || k == 2 ? 1.0L
                           : k == 1         ? 2.0L
                                            : 0.0L; });
}
TEST(TaylorSeries, AbsoluteValueAndNegation) {  // y' = -|y| with y > 0
  expect_law(coefficients([](auto, auto y) { return -abs(y); }, 1, 20),
             [](int k) { return (k % 2 ? -1 : 1) / factorial(k); });
}

TEST(Tape, RepeatsTheRightHandSideToTheBit) {
  for (const auto& id : problem_ids(suite_families())) {
    const auto problem = suite_problem(id);
    if (!(problem.abilities & Ability::recordable)) continue;  // it switches, or is too large
    const std::size_t n = problem.size();
    const auto& system = problem.system<double>();
    const auto tape = system.tape();
    TaylorSeries<double> series(tape, n, 1);
    std::vector<double> slope(n);
    for (const double t : {0.0, 0.375 * problem.t_end}) {
      system.rhs(t, problem.initial, slope);
      series.expand(t, problem.initial.data(), 1);
      for (std::size_t i = 0; i < n; ++i) EXPECT_TRUE(same_bits(series.coefficient(i, 1), slope[i])) << id;
    }
  }
}

TEST(Taylor, FirstOrderIsEulersMethod) {
  for (const char* id : {"oscillator", "pendulum", "lorenz63"}) {
    const auto problem = suite_problem(id);
    const auto a = solve(suite_method("taylor1"), problem, FixedSteps{2000}),
               b = solve(suite_method("explicit_euler"), problem, FixedSteps{2000});
    EXPECT_LT(scaled_gap(problem, a.y, b.y), 1e-10) << id;
  }
}

TEST(Taylor, OnALinearProblemItIsTheCutExponential) {
  const auto decay = suite_problem("dahlquist");
  for (const auto& method : suite_methods()) {
    if (method.kind != "Taylor series") continue;
    SCOPED_TRACE(method.id);
    const double h = 1.25;
    const auto m = method.runs<double>().transition(decay.system<double>(), h);
    double sum = 0;
    for (int k = method.order; k >= 0; --k) sum += std::pow(-h, k) / double(factorial(k));
    EXPECT_NEAR(m.columns[0], sum, 1e-14);
  }
}

/// Pulling more orders out of the same expansion costs no evaluation: a rejected step reuses its series.
TEST(Taylor, ARejectedStepCostsNoSeries) {
  RunRequest request;
  request.rtol = 1e-8;
  request.first_step = 5;
  request.trajectory = false;
  const Row row = run(suite_method("taylor8"), suite_problem("pendulum"), request, "taylor");
  ASSERT_EQ(row.status, "reached_end");
  EXPECT_GT(row.rejected, 0);
  EXPECT_EQ(row.work.series, row.accepted);
  EXPECT_EQ(row.work.rhs, 0) << "the first step was given";
  EXPECT_EQ(row.work.evaluations, 8 * row.work.series + row.work.rhs);
}

}  // namespace
}  // namespace odemark::taylor_test
