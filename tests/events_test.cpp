// Events: located by error control, noticed late by fixed steps, and never lost.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "bench/measure.hpp"
#include "bench/solve.hpp"
#include "integrators/bracket_root.hpp"
#include "reference/truth_compare.hpp"
#include "reference/truth_store.hpp"
#include "reference/truth_wide.hpp"
#include "tests/support/probe_families.hpp"
#include "tests/support/runs.hpp"

namespace odemark::events_test {
namespace {

Row tolerant_row(std::string_view method, const AnyProblem& problem, double rtol) {
  RunRequest request;
  request.rtol = rtol;
  return run(suite_method(method), problem, request, "events");
}
Row fixed_row(std::string_view method, const AnyProblem& problem, long steps) {
  RunRequest request;
  request.steps = steps;
  return run(suite_method(method), problem, request, "events");
}

TEST(BracketRoot, FindsTheLastBits) {
  int calls = 0;
  const auto f = [&](double x) { return ++calls, 2 - x * x; };
  EXPECT_NEAR(bracket_root(0.0, 2.0, 3.0, -7.0, 1e-15, f), std::sqrt(2.0), 2e-15);
  EXPECT_LE(calls, 14);
  const auto flat = [](double x) { return -std::pow(x - 1, 9); };
  EXPECT_NEAR(bracket_root(0.0, 1.0, 3.0, -512.0, 1e-12, flat), 1, 1e-1);
  EXPECT_LE(flat(bracket_root(0.0, 1.0, 3.0, -512.0, 1e-12, flat)), 0);
  const auto jump = [](double x) { return x < 1.25 ? 1.0 : -1e9; };
  const double end = bracket_root(0.0, 1.0, 2.0, -1e9, 1e-14, jump);
  EXPECT_LE(jump(end), 0);
  EXPECT_NEAR(end, 1.25, 2e-14);
}

TEST(BracketRoot, TakesNaNForTheFarSide) {
  const auto f = [](double x) { return x < 0.5 ? 1.0 : std::nan(""); };
  EXPECT_NEAR(bracket_root(0.0, 1.0, 1.0, -1.0, 1e-12, f), 0.5, 1e-9);
}

/// Linear equations with constant coefficients hide the error of ros3p from its estimate: who is far off
/// without any event cannot be asked where one is.
bool is_honest(const AnyMethod& method) {
  const Row row = tolerant_row(method.id, suite_problem("oscillator"), 1e-8);
  return row.errors && row.errors->scaled <= 1e-5;
}

/// Every method with an error estimate, on every preset whose events change something. It finds each of them,
/// in order, to the accuracy that its tolerance gives the state.
TEST(Events, ErrorControlLocatesAll) {
  int runs = 0, methods = 0;
  std::vector<std::string_view> dishonest;
  for (const auto& method : suite_methods())
    if (method.takes_error_control && can_run<double>(method, suite_problem("oscillator"))) {
      ++methods;
      if (!is_honest(method)) dishonest.push_back(method.id);
    }
  EXPECT_LE(dishonest.size(), std::size_t(methods) / 5);
  for (const char* id : {"bouncing_ball", "bouncing_ball_elastic", "bouncing_ball_zeno", "coulomb_brake",
                         "coulomb_brake_slope", "belt_stick_slip", "belt_stick_slip_slow", "thermostat"}) {
    const AnyProblem problem = suite_problem(id);
    for (const auto& method : suite_methods()) {
      if (!method.takes_error_control || method.embedded_order < 2 || method.order < 3) continue;
      if (!can_run<double>(method, problem) || method.id.starts_with("chapter")) continue;
      if (std::find(dishonest.begin(), dishonest.end(), method.id) != dishonest.end()) continue;
      const Row row = tolerant_row(method.id, problem, 1e-8);
      SCOPED_TRACE(row.id);
      ++runs;
      EXPECT_EQ(row.status, "reached_end") << row.reason;
      ASSERT_TRUE(row.events);
      EXPECT_EQ(row.events->found, row.events->expected);
      EXPECT_GT(row.events->expected, 0);
      EXPECT_LE(row.events->worst_time_error.value_or(1), 1e-5 * problem.t_end);
      ASSERT_TRUE(row.errors);
      EXPECT_LE(row.errors->scaled, 1e-4);
      EXPECT_LE(row.errors->trajectory_max.value_or(0), 1e-4);
    }
  }
  EXPECT_GT(runs, 20);
}

/// A parabola is exact for every method of order 2: what is left is the location itself.
TEST(Events, LocationIsGoodToAFewUlps) {
  const Row row = tolerant_row("dormand_prince54", suite_problem("bouncing_ball"), 1e-6);
  EXPECT_LE(row.events->worst_time_error.value(), 4e-15);
  EXPECT_LE(row.errors->scaled, 4e-14);
}

TEST(Events, FixedStepsNoticeThemLate) {
  const AnyProblem problem = suite_problem("bouncing_ball");
  double before = 1;
  for (const long steps : {150L, 1500L, 15000L}) {
    const Row row = fixed_row("rk4", problem, steps);
    ASSERT_TRUE(row.events);
    EXPECT_EQ(row.events->found, 3);
    const double late = row.events->worst_time_error.value();
    EXPECT_GT(late, 0);
    EXPECT_LT(late, before / 3);
    EXPECT_LE(late, 40 * problem.t_end / double(steps));
    EXPECT_GT(row.errors->scaled, 1e-6) << "order 4 does not help";
    before = late;
  }
  EXPECT_LT(tolerant_row("dormand_prince54", problem, 1e-6).errors->scaled,
            1e-6 * fixed_row("rk4", problem, 1500).errors->scaled);
}

TEST(Events, WithoutThemTheBallFallsThroughTheFloor) {
  const AnyProblem problem = suite_problem("bouncing_ball");
  const auto end = solve(suite_method("dormand_prince54"), problem, ErrorControl{1e-8, 1e-8});
  EXPECT_LT(end.y[0], -10);
}

TEST(Events, ABallComesToRest) {
  for (const Row& row : {tolerant_row("dormand_prince54", suite_problem("bouncing_ball_zeno"), 1e-8),
                         fixed_row("rk4", suite_problem("bouncing_ball_zeno"), 20000)}) {
    EXPECT_EQ(row.status, "reached_end");
    EXPECT_EQ(row.errors->absolute, 0) << row.id;
  }
}

/// A slip that lies inside one step shows neither at its start nor at its end.
TEST(Events, NoEventHidesInsideAStep) {
  const AnyProblem problem = suite_problem("belt_stick_slip_slow");
  for (const double rtol : {1e-2, 1e-3, 1e-4}) {
    const Row row = tolerant_row("dormand_prince54", problem, rtol);
    EXPECT_EQ(row.events->found, row.events->expected) << rtol;
  }
}

TEST(Events, ASwitchByTheClockIsNoLongerStumbledOver) {
  for (const char* id : {"sawtooth", "detest_f1", "detest_f2", "drag_ship_quadratic"}) {
    const AnyProblem problem = suite_problem(id);
    ErrorControl control{1e-9, 1e-9};
    control.scale = problem.scale.data();
    const auto blind = solve(suite_method("dormand_prince54"), problem, control);
    const Row row = tolerant_row("dormand_prince54", problem, 1e-9);
    EXPECT_LT(row.accepted + row.rejected, blind.report.accepted + blind.report.rejected) << id;
    EXPECT_LT(row.errors->scaled, 1e-7) << id;
  }
}

TEST(Events, AKinkChangesNoFixedStep) {
  const AnyProblem problem = suite_problem("drag_ship_quadratic");
  const Row row = fixed_row("rk4", problem, 777);
  EXPECT_EQ(row.state_hash, hash_bits(solve(suite_method("rk4"), problem, FixedSteps{777}).y));
  ASSERT_TRUE(row.events);
  EXPECT_EQ(row.events->found, 1);
  EXPECT_EQ(row.events->expected, 1);
  EXPECT_LE(row.events->worst_time_error.value(), problem.t_end / 777);
}

TEST(Events, EveryNumberTypeAndTheTimedRun) {
  for (const char* id : {"bouncing_ball", "thermostat", "detest_f2"})
    for (const ScalarType scalar :
         {ScalarType::float_type, ScalarType::double_type, ScalarType::long_double_type})
      for (const bool fixed : {false, true}) {
        RunRequest request;
        request.scalar = scalar, request.timing_repeats = 1, request.timing_seconds = 1e-4;
        if (fixed)
          request.steps = 4000;
        else
          request.rtol = 1e-5;
        const Row row = run(suite_method("dormand_prince54"), suite_problem(id), request, "types");
        EXPECT_EQ(row.status, "reached_end") << row.id;
        EXPECT_TRUE(row.timing) << row.id;  // it ended in the same bits, or it would have thrown
        EXPECT_LE(row.errors->scaled, fixed ? 1e-2 : 1e-3) << row.id;
      }
}

/// An event that fires again at once, for ever.
template <class Real = double>
struct Chatter {
  static constexpr std::string_view id = "chatter", title = id, equations = "x' = -1, back to 0",
                                    source = "us";
  Real t_end = 2;
  static constexpr auto parameters() {
    using P = Parameter<Chatter, Real>;
    return std::array{P{"t_end", "s", "end of the interval", &Chatter::t_end, positive}};
  }
  static constexpr std::array presets{Preset{"chatter", "", "an event that fires again at once"}};
  double suggested_dt() const { return 0.0625; }
  static constexpr std::size_t size = 1;
  static constexpr std::array<Component, size> components{{{"x", ""}}};
  static constexpr std::array<std::string_view, 1> events{"stop"};
  std::array<double, size> scale() const { return {1}; }
  template <class T>
  void initial(T* y) const {
    y[0] = T(1);
  }
  template <class T>
  void rhs(const T&, const T*, T* dydt) const {
    dydt[0] = T(-1);
  }
  template <class T>
  void event_values(const T&, const T* y, T* g) const {
    g[0] = y[0];
  }
  template <class T>
  void after_event(std::size_t, const T&, T* y) const {
    y[0] = T(0);
  }
};

TEST(Events, ChatteringEndsAsARowWithItsReason) {
  const AnyProblem problem = probe::problem<Chatter>();
  std::vector<double> y = problem.initial;
  Trace<double> trace;
  std::vector<FoundEvent> found;
  const auto report = solve_problem(suite_method("dormand_prince54"), problem, ErrorControl{1e-6, 1e-6}, y,
                                    trace, found, nullptr);
  EXPECT_EQ(report.status, RunStatus::step_limit);
  EXPECT_EQ(report.reason, "more events than can be meant");
  EXPECT_NEAR(report.t_reached, 1, 1e-6);
}

TEST(Events, TheTruthKnowsThem) {
  const AnyProblem problem = suite_problem("bouncing_ball");
  const auto truth = truth_of(problem);
  ASSERT_EQ(truth->events.size(), 3u);
  const double fall = std::sqrt(2 / 9.8125);
  EXPECT_NEAR(double(truth->events[0].t.hi), fall, 1e-15);
  EXPECT_NEAR(double(truth->events[1].t.hi), fall * 2.75, 1e-15);
  EXPECT_LE(truth->events[2].t.bound, 1e-40L);
}

/// Planted: the second computation has another ball, which rests after its second bounce.
TEST(Events, TwoComputationsWithDifferentEventsAreNoTruth) {
  const AnyProblem problem = suite_problem("bouncing_ball");
  const auto first = widened(problem, false),
             other = widened(suite_problem("bouncing_ball", "v_rest=3.75"), false);
  CertifyOptions options;
  options.digits = 25, options.sensitivity = false;
  EXPECT_NO_THROW(certify_wide(problem, first, first, {first.t_end}, options));
  try {
    certify_wide(problem, first, other, {first.t_end}, options);
    ADD_FAILURE() << "a different ball passed";
  } catch (const TruthUnavailable& why) {
    EXPECT_NE(std::string(why.what()).find("one computation finds 3 events and the other 2"),
              std::string::npos)
        << why.what();
  }
}

/// Planted: a stored event whose last digits are wrong, and one that is missing.
TEST(Events, AStoredEventIsVerified) {
  const AnyProblem problem = suite_problem("bouncing_ball");
  Truth stored = *truth_of(problem);
  EXPECT_EQ(verify(problem, stored, 2), "");
  const std::string right = stored.events[1].t.decimal;
  std::string wrong = right.substr(0, 30);
  wrong.back() = wrong.back() == '1' ? '2' : '1';
  stored.events[1].t = truth_value(wrong, stored.events[1].t.bound);
  EXPECT_NE(verify(problem, stored, 2), "");
  stored.events.pop_back();
  EXPECT_NE(verify(problem, stored, 2).find("2 events are stored, 3 computed"), std::string::npos);
}

}  // namespace
}  // namespace odemark::events_test
