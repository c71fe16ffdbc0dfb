// A run in float computes in float only, wider types go further down, and compensated sums lower the floor.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "integrators/catalogue.hpp"
#include "integrators/facts.hpp"
#include "integrators/tape.hpp"
#include "tests/support/probe_families.hpp"
#include "tests/support/runs.hpp"
#include "tests/support/strict_float.hpp"

namespace odemark::float_test {
namespace {

template <class F>
struct StrictSystem {
  using State = std::vector<StrictFloat>;
  F family;
  void rhs(StrictFloat t, const State& y, State& dydt) const { family.rhs(t, y.data(), dydt.data()); }
  void acceleration(StrictFloat t, const State& y, StrictFloat* a) const {
    family.acceleration(t, y.data(), a);
  }
  bool force_depends_on_velocity() const { return F::force_depends_on_velocity; }
  BodyPlace body_place() const requires requires { F::rate_at; }
  { return {F::rate_at, F::attitude_at}; }
  void inertia(StrictFloat* moments) const { family.inertia(moments); }
  void torque(StrictFloat t, const State& y, StrictFloat* out) const { family.torque(t, y.data(), out); }
  Tape<StrictFloat> tape() const { return record<StrictFloat>(family, F::size); }
  void count_series() const {}
};

/// The loop of integrate() on a stepper that knows no other number than StrictFloat.
template <const auto& method, class F>
std::vector<float> strict_end(const F& family, int steps) {
  using P = StrictSystem<F>;
  const P system{family};
  typename P::State y(F::size);
  family.initial(y.data());
  auto next = y, error = y;
  StepperOf<method, P> stepper(system, y);
  stepper.start();
  const StrictFloat h = StrictFloat(family.t_end) / StrictFloat(steps);
  for (int n = 0; n < steps; ++n) {
    EXPECT_EQ(stepper.attempt(StrictFloat(n) * h, y, h, next, error), StepStatus::ok);
    stepper.accept();
    std::swap(y, next);
  }
  std::vector<float> end;
  for (const auto& x : y) end.push_back(x.value);
  return end;
}

/// Implicit and exponential methods hand their matrices to linear algebra that is compiled for real floats;
/// kinds that choose their own steps have no step of a given size to compare.
template <class Kind>
concept LeavesLinearAlgebraToOthers =
    (Kind::needs & (Ability::linear_part | Ability::jacobian)) != 0 || requires {
  requires Kind::solves_equations;
}
|| requires { requires Kind::compiled_apart; }
|| requires { Kind::takes_fixed_steps; };

template <const auto& method, class F>
int compare(const F& family, const AnyProblem& problem) {
  using Kind = KindOf<method>;
  if constexpr (LeavesLinearAlgebraToOthers<Kind>) {
    return 0;
  } else if constexpr (requires { method.velocity; }) {
    if constexpr (method.velocity == decltype(method.velocity)::implicit) {
      return 0;
    } else {
      EXPECT_TRUE(same_bits(strict_end<method>(family, 100),
                            solve<float>(suite_method(method.id), problem, FixedSteps{100}).y))
          << method.id;
      return 1;
    }
  } else {
    EXPECT_TRUE(same_bits(strict_end<method>(family, 100),
                          solve<float>(suite_method(method.id), problem, FixedSteps{100}).y))
        << method.id;
    return 1;
  }
}

template <const auto& method>
int compare_where_it_runs(const AnyProblem& driven, const AnyProblem& top) {
  if constexpr ((KindOf<method>::needs & Ability::rotation) != 0)
    return compare<method>(probe::DrivenTop<double>{}, top);
  else
    return compare<method>(probe::Driven<double>{}, driven);
}

template <const auto&... methods>
int compare_all(MethodList<methods...>) {
  const auto driven = probe::problem<probe::Driven>(), top = probe::problem<probe::DrivenTop>();
  return (compare_where_it_runs<methods>(driven, top) + ...);
}

TEST(Float, SteppersNeverLeaveTheirNumberType) { EXPECT_GE(compare_all(SuiteMethods{}), 30); }

/// The least error over a ladder of steps.
template <class T>
double floor_of(const AnyMethod& method, const AnyProblem& problem, const std::vector<long double>& end) {
  double least = 1e300;
  for (long steps = 16; steps <= 4096; steps *= 2)
    least = std::min(least, scaled_gap(problem, solve<T>(method, problem, FixedSteps{steps}).y, end));
  return least;
}

TEST(Float, EveryMethodStopsWhereItsNumberTypeDoes) {
  const auto driven = probe::problem<probe::Driven>(), top = probe::problem<probe::DrivenTop>();
  const auto driven_end = fine_end(driven, 256), top_end = fine_end(top, 256);
  for (const auto& method : suite_methods()) {
    if (!method.takes_fixed_steps) continue;
    SCOPED_TRACE(method.id);
    const bool turns = method.needs & Ability::rotation;
    const AnyProblem& problem = turns ? top : driven;
    const auto& end = turns ? top_end : driven_end;
    const auto narrow = solve<float>(method, problem, FixedSteps{64}).y;
    const auto plain = solve<double>(method, problem, FixedSteps{64}).y;
    const auto wide = solve<long double>(method, problem, FixedSteps{64}).y;
    EXPECT_FALSE(same_bits(narrow, std::vector<float>(plain.begin(), plain.end())))
        << "as if computed in double and rounded";
    EXPECT_LT(scaled_gap(problem, narrow, plain), 1e-4);
    EXPECT_LT(scaled_gap(problem, plain, wide), 1e-13 * double(method.theory().rounding_amplification));
    if (method.order < 4) continue;
    const double in_float = floor_of<float>(method, problem, end),
                 in_double = floor_of<double>(method, problem, end);
    EXPECT_GT(in_float, 1e-9) << "better than float can be";
    EXPECT_LT(in_float, 1e-4);
    EXPECT_LT(in_double, 1e-3 * in_float);
    if (method.order >= 5) {
      EXPECT_LT(floor_of<long double>(method, problem, end), 0.3 * in_double);
    }
  }
}

double oscillator_error(long steps, bool compensated, std::string_view id) {
  const auto problem = suite_problem("oscillator");
  const std::vector<long double> end{std::cos(10.0L), -std::sin(10.0L)};
  return scaled_gap(problem, solve(suite_method(id), problem, FixedSteps{steps, compensated}).y, end);
}

/// The weights with which a step adds slopes up, each row of which should sum to 1: none where a method has
/// none, like a Taylor series.
std::vector<std::vector<Coefficient>> weights_of(const Theory& theory) {
  if (theory.tableau.stages > 0) return {theory.tableau.b};
  if (theory.nystrom.stages > 0) return {theory.nystrom.b_velocity};
  if (!theory.sigma.empty()) return {theory.sigma};
  std::vector<Coefficient> drifts, kicks;
  for (const auto& move : theory.moves)
    (move.what == SecondOrderMove::What::drift ? drifts : kicks).push_back(move.weight);
  if (drifts.empty()) return {{1}};
  return {drifts, kicks};
}

TEST(Float, CompensatedSumsLowerTheFloorToThatOfTheWeights) {
  // RK4 on the oscillator over 10 s, 65536 steps: round-off alone is left
  EXPECT_GT(oscillator_error(65536, false, "rk4"), 1e-15);
  EXPECT_LT(oscillator_error(65536, true, "rk4"), 1e-15);
  for (const auto& method : suite_methods()) {
    if (!method.compensated || method.order < 4) continue;
    SCOPED_TRACE(method.id);
    const Theory theory = method.theory();
    const MethodFacts facts = method_facts(theory, method.order, method.embedded_order);
    for (const long steps : {50'000L, 60'000L, 70'000L, 80'000L}) {
      // A step is rounded to double, then its product with every weight, itself rounded: together they
      // advance the solution by another time than 10 s, and it moves with speed 1. No sum of steps can mend
      // that.
      const double h = 10.0 / double(steps);
      double wrong_time = 0, size = 0;
      for (const auto& weights : weights_of(theory)) {
        Coefficient advance = 0;
        for (const Coefficient w : weights) advance += Coefficient(h * double(w));
        wrong_time = std::max(wrong_time, std::abs(double(advance * Coefficient(steps) - 10)));
        size = std::max(size, double(sum_of_magnitudes(weights)));
      }
      // beyond that: the state that is returned, the truth, and a small part of what the stages' own rounding
      // comes to if it never changes its sign, 10 s u sum |b|; all of it, twice, where stages are solved for
      // or weights are functions of a matrix; and the error of the method
      constexpr double unit = 0x1p-53;
      const bool rounds_weights = method.solves_equations || theory.exact_on_linear_part;
      const double rounding = unit * (3 + size + (rounds_weights ? 20 : 0));
      const double truncation =
          facts.error_constant ? 10 * double(*facts.error_constant) * std::pow(h, method.order) : 0;
      EXPECT_LT(oscillator_error(steps, true, method.id), wrong_time + rounding + truncation)
          << steps << " steps";
    }
  }
}

TEST(Float, ACompensatedRunDiffersFromThePlainOneOnlyByRoundOff) {
  const auto problem = probe::problem<probe::Driven>();
  for (const auto& method : suite_methods()) {
    if (!method.compensated) continue;
    const auto plain = solve(method, problem, FixedSteps{200}),
               sum = solve(method, problem, FixedSteps{200, true});
    EXPECT_EQ(sum.report.status, RunStatus::reached_end) << method.id;
    EXPECT_LT(scaled_gap(problem, plain.y, sum.y), 1e-13) << method.id;
  }
}

}  // namespace
}  // namespace odemark::float_test
