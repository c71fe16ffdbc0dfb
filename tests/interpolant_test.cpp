// Values between steps converge with the order that the method claims, over the catalogue; a wrong weight is
// seen.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "integrators/catalogue.hpp"
#include "integrators/erased_system.hpp"
#include "integrators/order_conditions.hpp"

namespace odemark::interpolant_test {
namespace {

/// y' = y (1 - y) + cos(t) / 8 and a second component that only looks: neither linear nor autonomous. The
/// truth is the same step by Taylor series of high order, in two parts.
using Real = long double;

ErasedSystem<Real> problem() {
  ErasedSystem<Real> system;
  system.size = 2;
  system.rhs_call = [](const void*, Real t, const Real* y, Real* dydt) {
    dydt[0] = y[0] * (1 - y[0]) + std::cos(t) / 8;
    dydt[1] = y[0] * y[1];
  };
  return system;
}

std::vector<Real> truth(Real t_end) {
  const auto system = problem();
  std::vector<Real> y{0.25L, 1}, next(2), error(2);
  StepperOf<feagin108, ErasedSystem<Real>> stepper(system, y);
  constexpr int steps = 16;
  for (int n = 0; n < steps; ++n) {
    stepper.start();
    stepper.attempt(t_end * n / steps, y, t_end / steps, next, error);
    std::swap(y, next);
  }
  return y;
}

/// Largest error inside a step of h from 0.
template <const auto& method>
Real worst_between(Real h) {
  const auto system = problem();
  const std::vector<Real> y{0.25L, 1};
  std::vector<Real> next(2), error(2), inside(2);
  StepperOf<method, ErasedSystem<Real>> stepper(system, y);
  stepper.start();
  stepper.attempt(0, y, h, next, error);
  Real worst = 0;
  for (const Real theta : {0.2L, 0.4L, 0.6L, 0.8L}) {
    stepper.interpolate(0, theta, y, h, inside);
    const auto exact = truth(theta * h);
    for (std::size_t i = 0; i < 2; ++i) worst = std::max(worst, std::abs(inside[i] - exact[i]));
  }
  stepper.interpolate(0, 1, y, h, inside);
  for (std::size_t i = 0; i < 2; ++i)
    EXPECT_NEAR(double(inside[i] - next[i]), 0, 1e-15)
        << method.id << ": theta = 1 is not the end of the step";
  return worst;
}

template <const auto& method>
double observed_order() {
  constexpr Real h = 0.125L;
  return double(std::log2(worst_between<method>(h) / worst_between<method>(h / 2)));
}

/// dormand_prince54 with one weight changed in its fourth digit, its sum kept.
inline constexpr auto wrong_dense = [] {
  auto method = dormand_prince54;
  method.dense[2][1] += 1e-4L, method.dense[2][2] -= 1e-4L;
  return method;
}();
/// dop853 whose last dense stage looks at another place.
inline constexpr auto wrong_dense_stage = [] {
  auto method = dop853;
  method.a_dense[3][13] += 1e-4L, method.a_dense[3][14] -= 1e-4L;
  return method;
}();

template <const auto&... methods>
int check_all(MethodList<methods...>) {
  int checked = 0;
  const auto check = [&]<const auto & method>() {
    if constexpr (requires { method.dense_order; }) {
      if constexpr (method.dense_order > 0) {
        const double order = observed_order<method>();
        // the error inside one step goes with h^(order + 1)
        EXPECT_GT(order, method.dense_order + 1 - 0.3) << method.id;
        EXPECT_LT(order, method.dense_order + 1 + 0.5) << method.id;
        ++checked;
      }
    }
  };
  (check.template operator()<methods>(), ...);
  return checked;
}

TEST(Interpolant, ConvergesWithItsOrderOverTheCatalogue) { EXPECT_GE(check_all(SuiteMethods{}), 4); }

TEST(Interpolant, AWrongWeightIsSeen) {
  EXPECT_LT(observed_order<wrong_dense>(), 2);
  EXPECT_LT(observed_order<wrong_dense_stage>(), 5);
}

/// What is excused of b(theta) is what its weights lose when they are rounded, and no more: a power of theta
/// is cleared of 2 u times one and the sum of the magnitudes of its weights (by the tree of one node; larger
/// trees excuse more) and has up to u of that itself. A slip of 3 u is therefore the smallest that must be
/// seen in every weight: 1e-17 of theta^2 to 6e-16 of theta^5 in dop853, whose weights are up to 545.
template <const auto& method>
void expect_every_weight_is_seen() {
  constexpr Coefficient unit = std::numeric_limits<Coefficient>::epsilon() / 2;
  EXPECT_EQ(algebraic_dense_order(method, method.dense_order + 1), method.dense_order) << method.id;
  for (std::size_t k = 0; k + 1 < highest_dense_degree; ++k) {
    Coefficient magnitudes = 0;
    for (const auto& weights : method.dense) magnitudes += std::abs(weights[k]);
    for (std::size_t j = 0; j < method.stages + method.dense_stages; ++j) {
      auto wrong = method;
      const Coefficient slip = 3 * unit * (1 + magnitudes);
      wrong.dense[j][k] += slip, wrong.dense[j][k + 1] -= slip;  // theta = 1 sees nothing
      EXPECT_LT(algebraic_dense_order(wrong, method.dense_order), method.dense_order)
          << method.id << " " << j << " " << k;
    }
  }
}

TEST(Interpolant, TheSmallestSlipInAWeightIsSeenByTheOrderConditions) {
  int methods = 0;
  const auto check = [&]<const auto & method>() {
    if constexpr (requires { method.dense_order; })
      if constexpr (method.dense_order > 0) expect_every_weight_is_seen<method>(), ++methods;
  };
  [&]<const auto&... suite>(MethodList<suite...>) { (check.template operator()<suite>(), ...); }
  (SuiteMethods{});
  EXPECT_GE(methods, 6);
  // what the stages between steps look at goes through one more product
  for (std::size_t stage = 1; stage < dop853.dense_stages; ++stage) {
    auto wrong = dop853;
    wrong.a_dense[stage][7] += 1e-14L, wrong.a_dense[stage][6] -= 1e-14L;  // the node stays
    EXPECT_LT(algebraic_dense_order(wrong, 8), 7) << stage;
  }
}

}  // namespace
}  // namespace odemark::interpolant_test
