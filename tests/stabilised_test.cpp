// Stabilised methods: their stability polynomials, stage choice and spectral radius, and the steppers against
// them.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "integrators/integrate.hpp"
#include "integrators/methods/rkc1.hpp"
#include "integrators/methods/rkc2.hpp"
#include "integrators/methods/rkl2.hpp"
#include "integrators/methods/rock2.hpp"
#include "integrators/methods/rock4.hpp"
#include "integrators/rock_polynomials.hpp"

namespace odemark::stabilised_test {
namespace {

using Complex = std::complex<Coefficient>;

constexpr std::array<const StabilisedRungeKutta*, 5> methods{&rkc1, &rkc2, &rkl2, &rock2, &rock4};

/// Every tenth of the numbers of stages that a family can take, with the ends.
std::vector<std::size_t> some_stages(StabilisedFamily family) {
  std::vector<std::size_t> chosen;
  Coefficient reach = 0;
  for (int n = 0; n < 40; ++n) {
    const std::size_t s = stages_for(family, reach, stage_cap(family));
    if (chosen.empty() || s != chosen.back()) chosen.push_back(s);
    reach = real_interval(family, s) * 1.6L;
  }
  EXPECT_EQ(chosen.back(), stage_cap(family));
  return chosen;
}

TEST(Stabilised, PolynomialsAreStableToTheEndAndNotMuchFurther) {
  for (const auto* m : methods)
    for (const std::size_t s : some_stages(m->family)) {
      const Coefficient beta = real_interval(m->family, s);
      Coefficient largest = 0;
      for (int i = 0; i <= 1000; ++i)
        largest = std::max(largest, std::abs(stability_value(m->family, s, -beta * Coefficient(i) / 1000)));
      EXPECT_LE(double(largest), 1 + 1e-15 * double(s * s)) << m->id << " with " << s;
      Coefficient beyond = 0;  // tiny numbers of stages have intervals that end before |R| = 1
      for (int i = 1; i <= 20; ++i)
        beyond = std::max(beyond, std::abs(stability_value(m->family, s, -beta * (1 + Coefficient(i) / 40))));
      EXPECT_GT(double(beyond), 1) << m->id << " with " << s << ": the interval is longer than claimed";
    }
}

TEST(Stabilised, IntervalsAreThePublishedOnes) {
  const auto per_square = [](const StabilisedRungeKutta& m, std::size_t s) {
    return double(real_interval(m.family, s)) / double(s * s);
  };
  EXPECT_NEAR(per_square(rkc1, 100), 2 - 4 * 0.05 / 3, 5e-3);
  EXPECT_NEAR(per_square(rkc2, 100), 2.0 / 3 * (1 - 2 * 2.0 / 13 / 15), 1e-3);
  EXPECT_EQ(double(real_interval(rkl2.family, 21)), (21 * 21 + 21 - 2) / 2);
  EXPECT_NEAR(double(real_interval(rock2.family, 10)), 79.5, 0.3);
  EXPECT_NEAR(per_square(rock2, stage_cap(rock2.family)), 0.81, 0.005);
  EXPECT_NEAR(per_square(rock4, stage_cap(rock4.family)), 0.353, 0.001);
}

TEST(Stabilised, OrdersOfTheLinearProblem) {
  for (const auto* m : methods)
    for (const std::size_t s : some_stages(m->family)) {
      if (s > 30) continue;
      const auto r = m->stability_polynomial(s);
      EXPECT_EQ(r.size(), s + 1) << m->id;
      Coefficient factorial = 1;
      for (int k = 0; k <= m->order; ++k) {
        if (k > 0) factorial *= Coefficient(k);
        EXPECT_NEAR(double(r[std::size_t(k)] * factorial - 1), 0, 1e-17 * double(s * s)) << m->id << " " << s;
      }
      if (r.size() > std::size_t(m->order + 1)) {
        EXPECT_GT(std::abs(double(r[std::size_t(m->order + 1)] * factorial * (m->order + 1) - 1)), 1e-2)
            << m->id;
      }
      const Coefficient beta = real_interval(m->family, s);
      for (const Complex z : {Complex(-0.3L * beta, 0.2L), Complex(-0.01L * beta, 1)}) {
        Complex sum = 0;
        Coefficient size = 0;
        for (std::size_t k = r.size(); k-- > 0;)
          sum = sum * z + r[k], size = size * std::abs(z) + std::abs(r[k]);
        EXPECT_LE(double(std::abs(sum - stability_value(m->family, s, z))), 1e-17 * double(size)) << m->id;
      }
    }
}

struct Complexes {
  using State = std::array<double, 2>;
  double re, im;
  template <class T>
  void rhs(T, const State& y, State& dydt) const {
    dydt[0] = re * y[0] - im * y[1], dydt[1] = im * y[0] + re * y[1];
  }
};

template <const auto& method>
void expect_its_polynomial() {
  for (const std::size_t s : some_stages(method.family))
    for (const Complex z : {Complex(-0.8L, 0), Complex(-0.5L, 0.7L), Complex(0.1L, 0.9L),
                            Complex(-0.5L * real_interval(method.family, s), 0),
                            Complex(-0.97L * real_interval(method.family, s), 0)}) {
      const Complexes system{double(z.real()), double(z.imag())};
      StepperOf<method, Complexes> stepper(system, Complexes::State{});
      stepper.fix_stages(s);
      stepper.start();
      Complexes::State next{}, error{};
      (void)stepper.attempt(0.0, Complexes::State{1, 0}, 1.0, next, error);
      EXPECT_EQ(stepper.stages(), s);
      const Complex expected = stability_value(method.family, s, Complex(system.re, system.im));
      const double growth = double(internal_amplification(method.family, s));
      EXPECT_LE(double(std::abs(Complex(next[0], next[1]) - expected)), 4e-16 * (10 + 4 * growth))
          << method.id << " with " << s << " at " << double(z.real()) << " + " << double(z.imag()) << " i";
    }
}

TEST(Stabilised, SteppersAreTheirPolynomials) {
  expect_its_polynomial<rkc1>();
  expect_its_polynomial<rkc2>();
  expect_its_polynomial<rkl2>();
  expect_its_polynomial<rock2>();
  expect_its_polynomial<rock4>();
}

/// u_t = u_xx + sin(t) u - u^3 on 99 inner points: spectral radius 4e4 at most.
struct Heat {
  using State = std::vector<double>;
  mutable long calls = 0;
  void rhs(double t, const State& y, State& dydt) const {
    ++calls;
    for (std::size_t i = 0; i < y.size(); ++i) {
      const double left = i ? y[i - 1] : 0, right = i + 1 < y.size() ? y[i + 1] : 0;
      dydt[i] = 1e4 * (left - 2 * y[i] + right) + std::sin(t) * y[i] - y[i] * y[i] * y[i];
    }
  }
};

template <const auto& method>
void expect_stable_diffusion() {
  const Heat heat;
  std::vector<double> y(99);
  for (std::size_t i = 0; i < y.size(); ++i)
    y[i] = std::sin(3.14159265358979 * double(i + 1) / 100) + 0.2 * double(i % 2);
  StepperOf<method, Heat> stepper(heat, y);
  const auto report = integrate(stepper, FixedSteps{100}, 0, 0.5, y);
  EXPECT_EQ(report.status, RunStatus::reached_end);
  EXPECT_LT(std::abs(y[49]), 0.02) << method.id;
  EXPECT_GT(y[49], 0.005) << method.id;
  EXPECT_GE(stepper.spectral_radius(), 0.97 * 4e4) << method.id;
  EXPECT_LE(stepper.spectral_radius(), 1.25 * 4e4) << method.id;
  const double reach = 0.005 * stepper.spectral_radius();
  EXPECT_GE(double(real_interval(method.family, stepper.stages())), reach) << method.id;
  EXPECT_LT(heat.calls, 100 * long(stepper.stages() + 2) + 5 * 60) << method.id;
}

TEST(Stabilised, StagesFollowTheSpectralRadius) {
  expect_stable_diffusion<rkc1>();
  expect_stable_diffusion<rkc2>();
  expect_stable_diffusion<rkl2>();
  expect_stable_diffusion<rock2>();
  expect_stable_diffusion<rock4>();
  for (const auto* m : methods) {
    for (const Coefficient reach : {0.0L, 1.0L, 7.5L, 100.0L, 999.0L, 5000.0L}) {
      const std::size_t s = stages_for(m->family, reach, stage_cap(m->family));
      EXPECT_GE(real_interval(m->family, s), reach) << m->id;
      std::size_t fewer = s - 2;  // would not do
      if (m == &rock2 || m == &rock4)
        for (const auto& polynomial : rock_polynomials(m->family))
          if (polynomial.stages < s) fewer = polynomial.stages;
      if (reach >= 100) {
        EXPECT_LT(real_interval(m->family, fewer), reach) << m->id;
      }
    }
    EXPECT_EQ(stages_for(m->family, 1e12L, 77), 77u);
    EXPECT_EQ(stages_for(m->family, std::nanl(""), 77), 77u);
  }
}

TEST(Stabilised, AStepBeyondTheCapIsRefused) {
  const Complexes fast{-1e9, 0};
  StepperOf<rkc2, Complexes> stepper(fast, Complexes::State{});
  Complexes::State next{}, error{};
  stepper.start();
  (void)stepper.attempt(0.0, Complexes::State{1, 0}, 1.0, next, error);
  EXPECT_TRUE(std::isnan(error[0]));
  (void)stepper.attempt(0.0, Complexes::State{1, 0}, 1e-6, next, error);
  EXPECT_FALSE(std::isnan(error[0]));
}

/// All eight trees up to order 4, of the recurrence and the last stages together, for every number of stages.
TEST(Stabilised, Rock4HasOrderFour) {
  const std::array<Coefficient, 8> expected{1,        1.0L / 2, 1.0L / 3,  1.0L / 6,
                                            1.0L / 4, 1.0L / 8, 1.0L / 12, 1.0L / 24};
  const auto slope_of = [](const std::array<Coefficient, 8>& g) {
    return std::array<Coefficient, 8>{1,           g[0], g[0] * g[0], g[1], g[0] * g[0] * g[0],
                                      g[0] * g[1], g[2], g[3]};
  };
  const auto largest_residual = [&](const RockPolynomial& polynomial, std::size_t trees, bool embedded) {
    const auto start = elementary_weights(polynomial.recurrence);
    std::array<std::array<Coefficient, 8>, 5> slopes;
    auto end = start;
    for (std::size_t i = 0; i < 4; ++i) {
      auto stage = start;
      for (std::size_t j = 0; j < i; ++j)
        for (std::size_t t = 0; t < 8; ++t) stage[t] += polynomial.finish.a[i][j] * slopes[j][t];
      slopes[i] = slope_of(stage);
      for (std::size_t t = 0; t < 8; ++t) end[t] += polynomial.finish.b[i] * slopes[i][t];
    }
    slopes[4] = slope_of(end);
    Coefficient worst = 0;
    for (std::size_t t = 0; t < trees; ++t) {
      Coefficient sum = embedded ? 0 : end[t] - expected[t];
      for (std::size_t i = 0; embedded && i < 5; ++i) sum += polynomial.finish.error[i] * slopes[i][t];
      worst = std::max(worst, std::abs(sum));
    }
    return worst;
  };
  for (auto polynomial : rock_polynomials(StabilisedFamily::rock4)) {
    EXPECT_LT(double(largest_residual(polynomial, 8, false)), 1e-15) << polynomial.stages;
    EXPECT_LT(double(largest_residual(polynomial, 4, true)), 1e-17) << polynomial.stages;
    EXPECT_GT(double(largest_residual(polynomial, 8, true)), 1e-4)
        << "an estimate of the order of the method";
    polynomial.finish.a[3][2] += 1e-12L;
    EXPECT_GT(double(largest_residual(polynomial, 8, false)), 1e-15) << "a wrong digit is seen";
  }
}

TEST(Stabilised, CapsFollowTheNumberType) {
  for (const auto* m : methods)
    for (const Coefficient u : {0x1p-24L, 0x1p-53L, 0x1p-64L}) {
      const std::size_t cap = stage_cap(m->family, u);
      EXPECT_LE(double(internal_amplification(m->family, cap) * u), 10 * std::sqrt(double(u))) << m->id;
      EXPECT_GE(cap, 9u) << m->id;
      EXPECT_LE(cap, stage_cap(m->family)) << m->id;
    }
}

TEST(Stabilised, NodesEndAtOne) {
  for (const auto* m : methods) {
    auto filled = room_for(m->family);
    fill_recurrence(m->family, stages_for(m->family, 60, stage_cap(m->family)), filled);
    EXPECT_NEAR(double(filled.stages[filled.count].node + filled.last[1]), 1, 1e-16) << m->id;
  }
}

/// The comparisons above bite: another number of stages or another damping is seen.
TEST(Stabilised, AnotherPolynomialIsSeen) {
  const Complexes system{-20, 0.3};
  StepperOf<rkc2, Complexes> stepper(system, Complexes::State{});
  Complexes::State next{}, error{};
  stepper.fix_stages(11);
  stepper.start();
  (void)stepper.attempt(0.0, Complexes::State{1, 0}, 1.0, next, error);
  const Complex taken(next[0], next[1]), z(-20, 0.3L);
  EXPECT_LT(double(std::abs(taken - stability_value(rkc2.family, 11, z))), 1e-13);
  EXPECT_GT(double(std::abs(taken - stability_value(rkc2.family, 10, z))), 1e-5);
  EXPECT_GT(double(std::abs(taken - stability_value(rkc1.family, 11, z))), 1e-5);
}

}  // namespace
}  // namespace odemark::stabilised_test
