// The parts of a right-hand side add up to it: drift and kick, linear part and rest, drive and undriven
// problem.
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "tests/support/wide_views.hpp"

namespace odemark::split_test {
namespace {

template <class T>
void expect_drift_and_kick(const AnyProblem& problem) {
  const auto& system = problem.system<T>();
  const std::size_t half = problem.size() / 2;
  ASSERT_EQ(problem.size(), 2 * half);
  for (const auto& place : places_of(problem, 6)) {
    const auto y = converted<T>(place.y);
    std::vector<T> slope(y.size()), a(half);
    system.rhs(static_cast<T>(place.t), y, slope);
    system.acceleration(static_cast<T>(place.t), y, a.data());
    for (std::size_t i = 0; i < half; ++i) {
      EXPECT_TRUE(same_bits(slope[i], y[half + i])) << "x' is not v";
      EXPECT_TRUE(same_bits(slope[half + i], a[i])) << "v' is not the acceleration";
    }
  }
}

TEST(Split, DriftAndKickAreTheRightHandSide) {
  int second_order_problems = 0;
  for (const auto& problem : every_preset()) {
    if (!(problem.abilities & Ability::second_order)) continue;
    SCOPED_TRACE(problem.id);
    ++second_order_problems;
    expect_drift_and_kick<float>(problem);
    expect_drift_and_kick<double>(problem);
    expect_drift_and_kick<long double>(problem);
  }
  EXPECT_GE(second_order_problems, 10);
}

TEST(Split, AForceThatClaimsNoVelocityHasNone) {
  std::map<std::string_view, bool> claims;  // of a family: does any preset of it depend on the velocity?
  for (const auto& problem : every_preset()) {
    if (!(problem.abilities & Ability::second_order)) continue;
    SCOPED_TRACE(problem.id);
    const std::size_t half = problem.size() / 2;
    bool depends = false;
    for (const auto& place : places_of(problem, 8)) {
      auto faster = place.y, back = place.y;  // friction that is at its greatest only changes its sign
      for (std::size_t i = half; i < faster.size(); ++i) {
        faster[i] += problem.scale[i];
        back[i] = -back[i];
      }
      std::vector<double> a(half), b(half), c(half);
      problem.system<double>().acceleration(place.t, place.y, a.data());
      problem.system<double>().acceleration(place.t, faster, b.data());
      problem.system<double>().acceleration(place.t, back, c.data());
      depends = depends || !same_bits(a, b) || !same_bits(a, c);
    }
    const bool separable = problem.abilities & Ability::separable;
    EXPECT_EQ(problem.system<double>().force_depends_on_velocity(), !separable);
    if (separable)
      EXPECT_FALSE(depends);
    else
      claims[problem.family] |= depends;  // a preset may set the damping to nothing
  }
  for (const auto& [family, depends] : claims) EXPECT_TRUE(depends) << family;
}

TEST(Split, TheUndrivenProblemRestsAtZeroAndIsTheLinearPart) {
  int linear_problems = 0;
  for (const auto& problem : every_preset()) {
    if (!problem.homogeneous) continue;
    SCOPED_TRACE(problem.id);
    ++linear_problems;
    const auto& undriven = *problem.homogeneous;
    ASSERT_TRUE(problem.abilities & Ability::linear_part);
    const std::size_t n = problem.size();
    const std::vector<double> zero(n, 0.0);
    std::vector<double> slope(n), linear(n * n), of_driven(n * n);
    undriven.system<double>().linear_part(MatrixView<double>{linear.data(), n});
    problem.system<double>().linear_part(MatrixView<double>{of_driven.data(), n});
    EXPECT_EQ(linear, of_driven);
    for (const auto& place : places_of(problem, 6)) {
      undriven.system<double>().rhs(place.t, zero, slope);
      for (const double s : slope) EXPECT_EQ(s, 0);
      undriven.system<double>().rhs(place.t, place.y, slope);
      for (std::size_t row = 0; row < n; ++row) {
        double sum = 0, size = 1e-300;
        for (std::size_t column = 0; column < n; ++column) {
          const double term = linear[column * n + row] * place.y[column];
          sum += term, size += std::abs(term);
        }
        EXPECT_NEAR((slope[row] - sum) / size, 0, 1e-15);
      }
    }
  }
  EXPECT_GE(linear_problems, 10);
}

/// f(t, y) - L y must not know the stiff scale: its Jacobian is that of f minus L.
TEST(Split, TheLinearPartIsPartOfTheJacobian) {
  for (const auto& problem : every_preset()) {
    if (!(problem.abilities & Ability::linear_part)) continue;
    SCOPED_TRACE(problem.id);
    const std::size_t n = problem.size();
    std::vector<double> linear(n * n), jacobian(n * n);
    problem.system<double>().linear_part(MatrixView<double>{linear.data(), n});
    problem.system<double>().jacobian(problem.t_begin, problem.initial,
                                      MatrixView<double>{jacobian.data(), n});
    if (problem.homogeneous) {
      EXPECT_EQ(linear, jacobian);
    }
    for (const double x : linear) EXPECT_TRUE(std::isfinite(x));
  }
}

}  // namespace
}  // namespace odemark::split_test
