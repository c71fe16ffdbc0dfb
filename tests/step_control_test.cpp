// The step controller: powers, the dead band, rejections; and planted faults in it that its demands catch.
#include <gtest/gtest.h>

#include <cmath>

#include "bench/family_system.hpp"
#include "bench/step_record.hpp"
#include "integrators/integrate.hpp"
#include "integrators/methods/bogacki_shampine32.hpp"
#include "integrators/methods/dormand_prince54.hpp"
#include "problems/lorenz63.hpp"
#include "reports/tolerance.hpp"
#include "tests/support/runs.hpp"

namespace odemark::step_control_test {
namespace {

TEST(QuickPower, IsGoodToAHundredThousandth) {
  for (const double x : {1e-20, 3e-7, 0.1, 0.5, 0.7071, 0.99, 1.0, 1.01, 1.4142, 1.5, 2.0, 17.0, 1e6, 1e100})
    for (const double p : {-0.5, -0.35, -0.1, -1.0 / 18, 0.0, 0.05, 0.25, 1.0}) {
      const double right = std::pow(x, p);
      EXPECT_NEAR(quick_power(x, p) / right, 1, 2e-5) << x << "^" << p;
    }
  static_assert(quick_power(4, 0.5) > 1.9999 && quick_power(4, 0.5) < 2.0001);
}

TEST(StepSizeFilter, KeepsTheStepInsideItsBandOnly) {
  ErrorControl control{1e-6, 1e-6};
  const int order = 5;
  StepSizeFilter filter(control, order);
  const double aim = std::pow(control.safety, order);
  const auto square_for = [&](double factor) { return std::pow(aim * std::pow(factor, -order), 2); };
  EXPECT_TRUE(filter.keeps(square_for(1.0)));
  EXPECT_TRUE(filter.keeps(square_for(0.94)));
  EXPECT_TRUE(filter.keeps(square_for(1.32)));
  EXPECT_FALSE(filter.keeps(square_for(0.92)));
  EXPECT_FALSE(filter.keeps(square_for(1.34)));
  EXPECT_FALSE(filter.keeps(std::nan("")));
  EXPECT_NEAR(filter.next_factor(square_for(2.0)), std::pow(2.0, 0.7), 1e-4);
  control.filter = elementary_filter;
  const StepSizeFilter never(control, order);
  EXPECT_FALSE(never.keeps(square_for(1.0)));
}

TEST(StepSizeFilter, AfterARejectionTheStepDoesNotGrowAtOnce) {
  for (const StepFilter* preset : step_filters) {
    ErrorControl control{1e-6, 1e-6, *preset};
    StepSizeFilter filter(control, 5);
    EXPECT_LE(filter.next_factor(9.0), control.safety) << preset->id;
    EXPECT_LE(filter.next_factor(1e-8), 1.0) << preset->id;
    EXPECT_GT(filter.next_factor(1e-8), 1.0) << preset->id;
    EXPECT_EQ(filter.next_factor(std::nan("")), control.smallest_factor) << preset->id;
    EXPECT_LE(filter.next_factor(1e-8), 1.0) << preset->id << ": NaN was a rejection too";
  }
}

const AnyProblem& lorenz() {
  static const AnyProblem problem = find_problem(suite_families(), "lorenz63_t5");
  return problem;
}

RowLocal judged(const AnyMethod& method, const ErrorControl& asked, const ErrorControl& promised) {
  const AnyProblem& problem = lorenz();
  std::vector<double> y = problem.initial;
  const std::vector<long double> start(y.begin(), y.end());
  StepRecord record(problem, start);
  Trace<double> trace;
  trace.on_step = [&](double t, const double* state) {
    record.add(static_cast<long double>(t), std::vector<long double>(state, state + y.size()));
    return true;
  };
  method.runs<double>().solve_traced(problem.system<double>(), problem.system<double>(), asked,
                                     problem.t_begin, problem.t_end, y, trace);
  return record.local_errors(promised, 100);
}

ErrorControl control_at(double tolerance) {
  ErrorControl control{tolerance, tolerance};
  control.scale = lorenz().scale.data();
  return control;
}

TEST(LocalErrors, AnHonestCodeDeceivesSeldom) {
  for (const char* id : {"dormand_prince54", "tsitouras54", "bogacki_shampine32"}) {
    const RowLocal local = judged(suite_method(id), control_at(1e-6), control_at(1e-6));
    EXPECT_GE(local.judged, 90) << id;
    EXPECT_LE(local.deceived, local.judged / 10) << id;
    EXPECT_GT(local.worst, 1e-4) << id << ": compared with itself";
  }
}

/// A controller that takes a thousandth of the error for the error: what ignoring rejections comes to.
TEST(LocalErrors, APlantedFaultInTheControllerIsSeen) {
  const RowLocal local = judged(suite_method("dormand_prince54"), control_at(1e-3), control_at(1e-6));
  EXPECT_GT(local.deceived, local.judged / 2);
  EXPECT_GT(local.worst, 10);
}

/// The chain rule of tolerances: a hundredth of the tolerance, a hundredth of the error.
TEST(Calibration, SlopeOfAnExactPowerAndOfAPlantedFault) {
  std::vector<Row> rows;
  for (const char* method : {"right", "ignores_rejections"})
    for (int digits = 2; digits <= 9; ++digits) {
      Row row;
      row.problem = "p", row.method = method, row.provider = "odemark", row.scalar = "double";
      row.order = 5, row.embedded_order = 4, row.rtol = std::pow(10.0, -digits), row.status = "reached_end";
      row.accepted = 90, row.rejected = 10;
      row.errors = RowErrors{};
      row.errors->scaled = method[0] == 'r' ? 3 * *row.rtol : 0.03 * std::sqrt(*row.rtol);
      rows.push_back(row);
    }
  rows.back().status = "step_limit", rows.back().errors.reset();
  const auto codes = calibrations(rows);
  ASSERT_EQ(codes.size(), 2u);
  ASSERT_TRUE(codes[0].slope && codes[1].slope && codes[0].expected_slope);
  EXPECT_NEAR(*codes[0].slope, 1, 1e-9);
  EXPECT_NEAR(*codes[1].slope, 0.5, 1e-9);
  EXPECT_EQ(*codes[0].expected_slope, 1);
  EXPECT_NEAR(codes[0].least_ratio(), 3, 1e-9);
  EXPECT_NEAR(codes[0].most_ratio(), 3, 1e-9);
  EXPECT_NEAR(codes[0].rejected_share(), 0.1, 1e-12);
  EXPECT_EQ(codes[1].failures, std::vector<std::string>{"step_limit"});
  const Table table = calibration_table(codes);
  ASSERT_EQ(table.rows.size(), 2u);
  EXPECT_EQ(table.rows[0][2].text, "3");
  EXPECT_EQ(table.rows[0][7].text, "–");  // no step was judged
  EXPECT_EQ(table.rows[1].back().text, "1 step_limit");
}

/// Every code reaches 1e-6 on a smooth problem to within a factor of 300 of what was asked, contestants
/// included: absolute tolerances in other units, or not passed on, would be out by the scales, 20 to 45.
TEST(Calibration, ToleranceMeansTheSameForEveryCode) {
  const AnyProblem damped = find_problem(suite_families(), "oscillator");
  for (const AnyMethod& method : suite_registry().methods) {
    if (!method.takes_error_control || method.kind == "chapter listing" || !can_run<double>(method, damped))
      continue;
    ErrorControl control{1e-5, 1e-5};
    // positions a thousand times smaller, the tolerance with them: nothing may change but the unit
    std::vector<double> ends[2];
    for (const double unit : {1.0, 0x1p-10}) {
      std::vector<double> y = damped.initial, scale = damped.scale;
      for (double& x : y) x *= unit;
      for (double& s : scale) s *= unit;
      control.scale = scale.data();
      control.first_step = 0.01;
      const auto report =
          method.runs<double>().solve(damped.system<double>(), control, damped.t_begin, damped.t_end, y);
      EXPECT_EQ(report.status, RunStatus::reached_end) << method.id;
      for (double& x : y) x /= unit;
      ends[unit != 1] = y;
    }
    EXPECT_LE(scaled_gap(damped, ends[0], ends[1]), 1e-7) << method.id;
  }
}

/// y' = -2000 (y - cos t): the end of the transient leaves a smooth solution, and a step limited by
/// stability. A controller must settle there: the steps of the second half stay within a factor of three, and
/// few are rejected.
struct Settling {
  using State = std::array<double, 1>;
  void rhs(double t, const State& y, State& dydt) const { dydt[0] = -2000 * (y[0] - std::cos(t)); }
};

struct Settled {
  RunReport report;
  double shortest = 1e300, longest = 0, end = 0;
};

template <const auto& method>
Settled settle(const StepFilter& filter) {
  const Settling problem;
  const ErrorControl control{1e-4, 1e-4, filter};
  Settling::State y{0};
  Settled result;
  StepperOf<method, Settling> stepper(problem, y);
  const auto watch = [&](double t0, const auto&, double t1, const auto&) {
    if (t0 > 0.75 && t1 < 1.5)
      result.shortest = std::min(result.shortest, t1 - t0),
      result.longest = std::max(result.longest, t1 - t0);
    return true;
  };
  result.report = integrate(stepper, problem, control, method.embedded_order + 1, 0, 1.5, y, watch);
  result.end = y[0];
  return result;
}

template <const auto& method>
void expect_settled(const StepFilter& filter) {
  const Settled result = settle<method>(filter);
  ASSERT_EQ(result.report.status, RunStatus::reached_end);
  EXPECT_LE(result.longest, 3 * result.shortest) << method.id << " " << filter.id;
  EXPECT_LE(result.report.rejected, result.report.accepted / 4) << method.id << " " << filter.id;
  EXPECT_NEAR(result.end, std::cos(1.5), 1e-3) << method.id << " " << filter.id;
}

TEST(StepSettling, EveryFilterLivesWithTheStabilityLimit) {
  for (const StepFilter* filter : step_filters) {
    expect_settled<dormand_prince54>(*filter);
    expect_settled<bogacki_shampine32>(*filter);
  }
}

TEST(StepSettling, APlantedFilterThatDoesNotSettleIsSeen) {
  const StepFilter eager{"eager", 1, 0, 0, 0.93, 1.33};
  const auto result = settle<bogacki_shampine32>(eager);
  EXPECT_GT(result.report.rejected, result.report.accepted / 4);
}

}  // namespace
}  // namespace odemark::step_control_test
