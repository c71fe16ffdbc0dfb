// Claimed order against observed order: every method with fixed steps, on every kind of problem it can run.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <regex>

#include "reports/observed_order.hpp"
#include "tests/support/probe_families.hpp"
#include "tests/support/runs.hpp"

namespace odemark {
namespace {

/// A problem and where it ends, to more digits than any run here can reach.
struct Ground {
  AnyProblem problem;
  std::vector<long double> end;
  bool nonlinear, driven;
};

/// High orders need long intervals: on short ones two rungs of the ladder lead from nothing to round-off.
std::vector<Ground> make_grounds(bool long_ones) {
  std::vector<Ground> made;
  const auto add = [&](auto make, double short_end, double long_end, bool nonlinear, bool driven) {
    AnyProblem problem = make(fmt::format("t_end={}", long_ones ? long_end : short_end));
    auto end = fine_end(problem, 1024);
    made.push_back({std::move(problem), std::move(end), nonlinear, driven});
  };
  const auto suite = [](const char* id, const char* more = "") {
    return [=](const std::string& settings) { return suite_problem(id, settings + more); };
  };
  add([](const std::string& s) { return probe::problem<probe::Driven>(s); }, 2, 8, true, true);
  add([](const std::string& s) { return probe::problem<probe::DrivenDamped>(s); }, 2, 8, true, true);
  add(suite("pendulum"), 1.5, 12, true, false);
  add(suite("kepler_e02"), 2, 24, true, false);
  add(suite("van_der_pol_mu1"), 2, 8, true, false);
  add(suite("lorenz63"), 0.5, 3, true, false);
  add(suite("free_rigid_body"), 1.5, 12, true, false);
  add(suite("stiff_spring", ",k=4,c=0.5"), 2, 16, false, true);
  return made;
}
const std::vector<Ground>& grounds(bool long_ones = false) {
  static const std::vector<Ground> short_grounds = make_grounds(false), long_grounds = make_grounds(true);
  return long_ones ? long_grounds : short_grounds;
}

/// "order 1 where the force depends on velocity" in a method's note lowers the expectation there.
int expected_order(const AnyMethod& method, const AnyProblem& problem) {
  if ((problem.abilities & Ability::separable) || !(problem.abilities & Ability::second_order))
    return method.order;
  const std::string note(method.note);
  std::smatch found;
  if (std::regex_search(note, found, std::regex("order ([0-9]+) where the force depends on velocity")))
    return std::stoi(found[1]);
  return method.order;
}

template <class T>
ObservedOrder measure(const AnyMethod& method, const Ground& ground) {
  const AnyProblem& problem = ground.problem;
  const int order = expected_order(method, problem);
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
  const bool high = method.order > 6;
  for (const auto& ground : grounds(high)) {
    if (!can_run<double>(method, ground.problem)) continue;
    const ObservedOrder order = high ? measure<long double>(method, ground) : measure<double>(method, ground);
    std::printf("%-36s %-28s claimed %2d observed %6.3f +- %.3f (%d points) %s\n",
                std::string(method.id).c_str(), ground.problem.id.c_str(), order.claimed,
                order.slope.value_or(0), order.standard_error.value_or(0), order.points,
                std::string(to_string(order.verdict)).c_str());
    // The highest orders reach round-off within three or four rungs, still on their way to the limit: their
    // order is proved on the cut exponential (taylor_test); here they must only come near it wherever
    // anything can be told.
    if (method.order > 10) {
      if (order.slope) {
        EXPECT_GE(*order.slope, 0.75 * method.order) << ground.problem.id;
      }
      continue;
    }
    ++measured, nonlinear += ground.nonlinear, driven += ground.driven;
    holds += order.verdict == OrderVerdict::holds;
    // better than claimed happens where an error term vanishes; worse, or not to be told, must not
    EXPECT_TRUE(order.verdict == OrderVerdict::holds || order.verdict == OrderVerdict::exceeds)
        << ground.problem.id << ": " << to_string(order.verdict) << ", " << order.reason;
  }
  if (method.order > 10) return;
  EXPECT_GE(measured, 3);
  EXPECT_GE(nonlinear, 1);
  EXPECT_GE(driven, 1);
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
    if (!method.takes_error_control || !method.takes_fixed_steps) continue;
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
