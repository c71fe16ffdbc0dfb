// Claimed order against observed order: every method with fixed steps, on every kind of problem it can run.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "bench/expected_order.hpp"
#include "integrators/lowered_order.hpp"
#include "reports/observed_order.hpp"
#include "tests/support/probe_families.hpp"
#include "tests/support/runs.hpp"

namespace odemark {
namespace {

/// A problem and where it ends, to more digits than any run here can reach.
struct Ground {
  AnyProblem problem;
  std::vector<long double> end;
  bool nonlinear, driven, damped;
  bool turning = false;  // only for methods that need a rigid body
};

/// High orders need long intervals: on short ones two rungs of the ladder lead from nothing to round-off.
std::vector<Ground> make_grounds(bool long_ones) {
  std::vector<Ground> made;
  const auto add = [&](auto make, double short_end, double long_end, bool nonlinear, bool driven,
                       bool damped) {
    AnyProblem problem = make(fmt::format("t_end={}", long_ones ? long_end : short_end));
    auto end = fine_end(problem, 1024);
    made.push_back({std::move(problem), std::move(end), nonlinear, driven, damped});
  };
  const auto suite = [](const char* id, const char* more = "") {
    return [=](const std::string& settings) { return suite_problem(id, settings + more); };
  };
  add([](const std::string& s) { return probe::problem<probe::Driven>(s); }, 2, 8, true, true, false);
  add([](const std::string& s) { return probe::problem<probe::DrivenDamped>(s); }, 2, 8, true, true, true);
  add(suite("pendulum"), 1.5, 12, true, false, false);
  add(suite("kepler_e02"), 2, 24, true, false, false);
  add(suite("van_der_pol_mu1"), 2, 8, true, false, true);
  add(suite("lorenz63"), 0.5, 3, true, false, true);
  add(suite("free_rigid_body"), 1.5, 12, true, false, false);
  add(suite("stiff_spring", ",k=4,c=0.5"), 2, 16, false, true, true);
  const std::size_t first_body = made.size();
  add([](const std::string& s) { return probe::problem<probe::DrivenTop>(s); }, 2, 8, true, true, false);
  add(suite("free_rigid_body_tumbling"), 2, 8, true, false, false);
  add([](const std::string& s) { return probe::problem<probe::DampedTop>(s); }, 2, 8, true, true, true);
  for (std::size_t i = first_body; i < made.size(); ++i) made[i].turning = true;
  return made;
}
const std::vector<Ground>& grounds(bool long_ones = false) {
  static const std::vector<Ground> short_grounds = make_grounds(false), long_grounds = make_grounds(true);
  return long_ones ? long_grounds : short_grounds;
}

template <class T>
ObservedOrder measure(const AnyMethod& method, const Ground& ground) {
  const AnyProblem& problem = ground.problem;
  const int order = expected_order(method, problem).order;
  // the higher the order, the fewer powers of two lie between "too coarse" and round-off
  const double ratio = order > 6 ? 1.15 : order > 4 ? 1.3 : order > 2 ? 1.6 : 2;
  std::vector<Row> rows;
  long previous = 0;
  for (double wished = 6; wished < 20'000 && rows.size() < 60; wished *= ratio) {
    const long steps = std::lround(wished);
    if (steps == previous) continue;
    previous = steps;
    const auto end = solve<T>(method, problem, FixedSteps{steps});
    Row row;
    row.problem = problem.id, row.method = std::string(method.id), row.order = order;
    row.scalar = sizeof(T) == sizeof(double) ? "double" : "long_double";
    row.steps = steps, row.dt = (problem.t_end - problem.t_begin) / static_cast<double>(steps);
    row.status = to_string(end.report.status);
    if (end.report.status == RunStatus::reached_end)
      row.errors.emplace().scaled = scaled_gap(problem, end.y, ground.end);
    rows.push_back(row);
    const double floor = 50 * 8 * unit_roundoff(row.scalar);
    if (row.errors && row.errors->scaled < floor) break;
  }
  // slopes approach a high order as slowly as a low one, in proportion
  OrderOptions options;
  options.slack = std::max(options.slack, 0.04 * order);
  options.slope_scatter = std::max(options.slope_scatter, 0.03 * order);
  return observed_order(rows, options);
}

class Convergence : public testing::TestWithParam<AnyMethod> {};

TEST_P(Convergence, ClaimedOrderIsObserved) {
  const AnyMethod& method = GetParam();
  int measured = 0, holds = 0, nonlinear = 0, driven = 0;
  const bool proved_pair = method.order > 6 && method.theory().nystrom.stages > 0;
  // order_conditions_test proves the exact order of a tableau. The high ones reach round-off where their
  // error still changes sign between the rungs: one ground tells little, the middle of all of them does.
  const bool proved = method.theory().tableau.stages > 0 &&
                      (method.order > 6 || (method.order == 6 && method.theory().rounding_amplification > 1));
  std::vector<double> slopes;
  // the expansion of linearly implicit steps in h, not h^2, comes to its leading term later than others
  // and in double large weights that cancel end the ladder before it tells anything
  const int low =
      method.kind == "linearly implicit extrapolation" || method.theory().rounding_amplification > 1 ? 5 : 6;
  for (std::size_t n = 0; n < grounds().size(); ++n) {
    if (!can_run<double>(method, grounds()[n].problem)) continue;
    if (grounds()[n].turning && !(method.needs & Ability::rotation)) continue;
    const bool high = expected_order(method, grounds()[n].problem).order > low;
    const Ground& ground = grounds(high)[n];
    const ObservedOrder order = high ? measure<long double>(method, ground) : measure<double>(method, ground);
    std::printf("%-36s %-28s claimed %2d observed %6.3f +- %.3f (%d points) %s\n",
                std::string(method.id).c_str(), ground.problem.id.c_str(), order.claimed,
                order.slope.value_or(0), order.standard_error.value_or(0), order.points,
                std::string(to_string(order.verdict)).c_str());
    // The highest orders reach round-off within three or four rungs, still on their way to the limit: their
    // order is proved on the cut exponential (taylor_test); here they must only come near it wherever
    // anything can be told.
    if (method.order > 10 || proved) {
      if (order.slope) {
        slopes.push_back(*order.slope);
        EXPECT_GE(*order.slope, 0.75 * method.order) << ground.problem.id;
      }
      continue;
    }
    if (is_weakly_stable(method.theory())) {
      EXPECT_EQ(expected_order(method, ground.problem).order == 0, ground.damped) << ground.problem.id;
      // what it makes of the rounding and of the start is no error term with an order
      if (ground.damped) continue;
    }
    ++measured, nonlinear += ground.nonlinear, driven += ground.driven;
    // Its terms of that order are made so small that those of the next are seen beside them: exactly this
    // order is proved by trees (order_conditions_test), and what is seen must come near it from either side.
    if (proved_pair) {
      ASSERT_TRUE(order.slope) << ground.problem.id << ": " << order.reason;
      EXPECT_GE(*order.slope, 0.93 * method.order) << ground.problem.id;
      EXPECT_LE(*order.slope, method.order + 1) << ground.problem.id;
      continue;
    }
    holds += order.verdict == OrderVerdict::holds;
    // better than claimed happens where an error term vanishes; worse, or not to be told, must not
    EXPECT_TRUE(order.verdict == OrderVerdict::holds || order.verdict == OrderVerdict::exceeds)
        << ground.problem.id << ": " << to_string(order.verdict) << ", " << order.reason;
  }
  if (proved) {
    ASSERT_GE(slopes.size(), 4u);
    std::sort(slopes.begin(), slopes.end());
    EXPECT_GE(slopes[slopes.size() / 2], 0.96 * method.order - 0.3);
    return;
  }
  if (method.order > 10) return;
  EXPECT_GE(measured, 3);
  EXPECT_GE(nonlinear, 1);
  EXPECT_GE(driven, 1);
  if (proved_pair) return;
  EXPECT_GE(2 * holds, measured) << "the claim is too low";
}

std::vector<AnyMethod> fixed_step_methods() {
  std::vector<AnyMethod> chosen;
  for (const auto& method : suite_methods())
    if (method.takes_fixed_steps) chosen.push_back(method);
  return chosen;
}

INSTANTIATE_TEST_SUITE_P(Suite, Convergence, testing::ValuesIn(fixed_step_methods()),
                         [](const auto& instance) { return std::string(instance.param.id); });

/// The yardstick itself, against the closed form of a driven nonlinear problem.
TEST(Yardstick, TaylorOfTwentyOrdersMeetsTheClosedForm) {
  const auto& ground = grounds().front();
  const long double t = static_cast<long double>(ground.problem.t_end);
  EXPECT_NEAR(double(ground.end[0] - std::sin(t)), 0, 1e-17);
  EXPECT_NEAR(double(ground.end[1] - std::cos(t)), 0, 1e-17);
}

/// Under error control a smaller tolerance gives a smaller error, in proportion to its theory within wide
/// limits.
TEST(ErrorControl, ErrorFollowsTolerance) {
  for (const auto& method : suite_methods()) {
    if (!method.takes_error_control || method.kind == "chapter listing") continue;  // its faults are kept
    SCOPED_TRACE(method.id);
    const auto& ground = grounds()[2];
    if (!can_run<double>(method, ground.problem)) continue;
    const double loose = method.order < 3 ? 1e-3 : 1e-4, tight = loose * 1e-3;
    const auto coarse = solve(method, ground.problem, ErrorControl{loose, loose});
    const auto fine = solve(method, ground.problem, ErrorControl{tight, tight});
    ASSERT_EQ(coarse.report.status, RunStatus::reached_end);
    ASSERT_EQ(fine.report.status, RunStatus::reached_end);
    const double coarse_error = scaled_gap(ground.problem, coarse.y, ground.end),
                 fine_error = scaled_gap(ground.problem, fine.y, ground.end);
    EXPECT_LT(fine_error, coarse_error);
    // error per step: h ~ tolerance^(1/k), and 1/h steps, each off by the tolerance
    const double k = std::min(method.order, method.embedded_order) + 1, power = (k - 1) / k;
    EXPECT_LT(fine_error, 100 * std::pow(tight, power));
    EXPECT_LT(coarse_error, 100 * std::pow(loose, power));
  }
}

}  // namespace
}  // namespace odemark
