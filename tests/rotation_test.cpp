// Rotation methods: what each of them keeps, what it loses, and the hard cases that engines meet.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "integrators/erase_method.hpp"
#include "integrators/methods/rigid_body_splitting.hpp"
#include "integrators/rotation_step.hpp"
#include "tests/support/probe_families.hpp"
#include "tests/support/runs.hpp"

namespace odemark::rotation_test {
namespace {

const char* const all[] = {"quaternion_euler_normalised",
                           "exponential_map",
                           "implicit_gyroscopic",
                           "momentum_clamped_explicit",
                           "buss2",
                           "rigid_body_splitting",
                           "rkmk4"};

/// The largest relative distance of each invariant from its start, over a run.
struct Drift {
  double energy = 0, momentum_length = 0, quaternion = 0, momentum_in_space = 0;
};

Drift drift(const AnyMethod& method, const AnyProblem& problem, long steps) {
  const auto invariants = [&](const double* y) {
    std::vector<long double> wide(y, y + 7), out(6);
    problem.invariants_call(problem.value.get(), wide.data(), out.data());
    return out;
  };
  const auto start = invariants(problem.initial.data());
  Drift worst;
  const auto raise = [](double& w, long double error) {
    if (!(std::abs(double(error)) <= w)) w = std::abs(double(error));
  };
  Trace<double> trace;
  trace.on_step = [&](double, const double* y) {
    const auto now = invariants(y);
    raise(worst.energy, now[0] / start[0] - 1);
    raise(worst.momentum_length, now[1] / start[1] - 1);
    raise(worst.quaternion, now[2] - 1);
    for (std::size_t i = 3; i < 6; ++i)
      raise(worst.momentum_in_space, (now[i] - start[i]) / std::sqrt(start[1]));
    return true;
  };
  std::vector<double> y = problem.initial;
  method.runs<double>().solve_traced(problem.system<double>(), problem.system<double>(), FixedSteps{steps}, 0,
                                     problem.t_end, y, trace);
  return worst;
}

TEST(Rotation, TheyAreInTheCatalogueAndNeedABody) {
  for (const char* id : all) {
    EXPECT_EQ(suite_method(id).needs, unsigned(Ability::rotation)) << id;
    EXPECT_FALSE(can_run<double>(suite_method(id), suite_problem("oscillator"))) << id;
    EXPECT_TRUE(can_run<double>(suite_method(id), suite_problem("free_rigid_body"))) << id;
  }
}

TEST(Rotation, WhatEachKeepsOfATumblingBody) {
  const auto problem = suite_problem("free_rigid_body_tumbling", "t_end=100");
  constexpr long steps = 5000;  // 20 ms at 1.7 rad/s
  for (const char* id : all) {
    SCOPED_TRACE(id);
    const Drift d = drift(suite_method(id), problem, steps);
    std::printf("%-28s energy %.2e |L| %.2e |q| %.2e L in space %.2e\n", id, d.energy, d.momentum_length,
                d.quaternion, d.momentum_in_space);
    EXPECT_LT(d.quaternion, 1e-12) << "all of them turn by rotations";
    const std::string name = id;
    const bool keeps_momentum = name == "buss2" || name == "rigid_body_splitting";
    const bool keeps_length = keeps_momentum || name == "momentum_clamped_explicit";
    EXPECT_EQ(d.momentum_length < 1e-11, keeps_length);
    EXPECT_EQ(d.momentum_in_space < 1e-11, keeps_momentum);
    EXPECT_GT(d.energy, 1e-13) << "none of them keeps the energy itself";
  }
  // explicit Euler as a right-hand side keeps nothing: the yardstick of this test can see a loss
  EXPECT_GT(drift(suite_method("explicit_euler"), problem, steps).quaternion, 1e-2);
}

TEST(Rotation, TheSplittingsEnergyErrorIsBounded) {
  const auto brief = suite_problem("free_rigid_body_tumbling", "t_end=100"),
             lasting = suite_problem("free_rigid_body_tumbling", "t_end=3000");
  const auto ratio = [&](const char* id) {
    return drift(suite_method(id), lasting, 60'000).energy / drift(suite_method(id), brief, 2'000).energy;
  };
  EXPECT_LT(ratio("rigid_body_splitting"), 1.05);
  EXPECT_GT(ratio("rkmk4"), 10);  // 30 times as long: in proportion
}

/// The momentum in the body after one step, from a momentum before it.
using Momentum = std::array<long double, 3>;
Momentum after_a_step(const AnyMethod& method, const AnyProblem& problem, const Momentum& l, long double h) {
  constexpr long double inertia[3] = {13, 10, 5};
  std::vector<long double> y{l[0] / inertia[0], l[1] / inertia[1], l[2] / inertia[2], 1, 0, 0, 0};
  method.runs<long double>().solve(problem.system<long double>(), FixedSteps{1}, 0, double(h), y);
  return {y[0] * inertia[0], y[1] * inertia[1], y[2] * inertia[2]};
}

/// Of M B(l) M' - B(l+), where M is the derivative of the step and B the bracket of angular momentum, {l_i,
/// l_j} = - sum_k e_ijk l_k: the largest entry, relative to |l|.
double poisson_defect(const AnyMethod& method, const AnyProblem& problem, long double h) {
  const Momentum l{13, 12, -6}, end = after_a_step(method, problem, l, h);
  long double m[3][3];
  for (std::size_t j = 0; j < 3; ++j) {
    Momentum up = l, down = l;
    up[j] += 1e-4L, down[j] -= 1e-4L;
    const Momentum a = after_a_step(method, problem, up, h), b = after_a_step(method, problem, down, h);
    for (std::size_t i = 0; i < 3; ++i) m[i][j] = (a[i] - b[i]) / 2e-4L;
  }
  const auto bracket = [](const Momentum& v, std::size_t i, std::size_t j) {
    return i == j ? 0.0L : (j == (i + 1) % 3 ? -1 : 1) * v[3 - i - j];
  };
  double worst = 0;
  for (std::size_t r = 0; r < 3; ++r)
    for (std::size_t c = 0; c < 3; ++c) {
      long double sum = -bracket(end, r, c);
      for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) sum += m[r][i] * bracket(l, i, j) * m[c][j];
      worst = std::max(worst, std::abs(double(sum)) / 18.7);
    }
  return worst;
}

TEST(Rotation, TheSplittingAloneIsPoissonAndStepsBackToTheStart) {
  const auto problem = suite_problem("free_rigid_body_tumbling");
  for (const char* id : all) {
    SCOPED_TRACE(id);
    const AnyMethod& method = suite_method(id);
    std::vector<double> y = problem.initial;
    method.runs<double>().solve(problem.system<double>(), FixedSteps{1}, 0, 0.25, y);
    method.runs<double>().solve(problem.system<double>(), FixedSteps{1}, 0.25, 0, y);
    const double defect = poisson_defect(method, problem, 0.25L),
                 gap = scaled_gap(problem, y, problem.initial);
    if (std::string(id) == "rigid_body_splitting") {
      EXPECT_LT(defect, 1e-10) << "what differences leave";
      EXPECT_LT(gap, 4e-15);
    } else {
      EXPECT_GT(defect, 1e-6);
      EXPECT_GT(gap, 1e-8);
    }
    std::printf("%-28s Poisson defect %.1e, step and back %.1e\n", id, defect, gap);
  }
}

TEST(Rotation, AConstantSpinIsExactForTheExponentialMapsAndLagsForQuaternionEuler) {
  // 15 rad/s about one axis at 60 Hz, one second
  const auto problem = suite_problem("free_rigid_body", "I1=10,I2=10,I3=10,w1=0,w2=0,w3=15,t_end=1");
  const auto turned = [&](const char* id) {
    const auto y = solve(suite_method(id), problem, FixedSteps{60}).y;
    return 2 * std::atan2(y[6], y[3]);
  };
  const double turn = std::remainder(15.0, 4 * std::acos(-1.0));
  for (const char* id :
       {"exponential_map", "momentum_clamped_explicit", "buss2", "rigid_body_splitting", "rkmk4"})
    EXPECT_NEAR(std::remainder(turned(id) - turn, 4 * std::acos(-1.0)), 0, 1e-12) << id;
  for (const char* id : {"quaternion_euler_normalised", "implicit_gyroscopic"})
    EXPECT_NEAR(std::remainder(turned(id) - 60 * 2 * std::atan(15.0 / 120), 4 * std::acos(-1.0)), 0, 1e-12)
        << id;
  EXPECT_NEAR(15 - 60 * 2 * std::atan(15.0 / 120), 4.4 * std::acos(-1.0) / 180, 1e-3);
}

/// By what the rate across the axis of a rod grows in so many steps.
double transverse_growth(const char* id, double h, long steps = 1) {
  // moments 1, 1, 0.1 kg m^2: Omega = 0.9 w3 = 50 rad/s
  const auto problem =
      suite_problem("free_rigid_body", "I1=1,I2=1,I3=0.1,w1=1e-3,w2=0,w3=" + std::to_string(50 / 0.9));
  std::vector<double> y = problem.initial;
  suite_method(id).runs<double>().solve(problem.system<double>(), FixedSteps{steps}, 0, h * double(steps), y);
  return std::hypot(y[0], y[1]) / 1e-3;
}

TEST(Rotation, AnExplicitGyroscopicTermMakesARodTumble) {
  const double h = 1.0 / 60, explicit_growth = std::sqrt(1 + 50 * 50 * h * h);
  for (const char* id : {"quaternion_euler_normalised", "exponential_map"})
    EXPECT_NEAR(transverse_growth(id, h), explicit_growth, 1e-5) << id;
  // one Newton step on a linear problem is all of implicit Euler
  EXPECT_NEAR(transverse_growth("implicit_gyroscopic", h), 1 / explicit_growth, 1e-5);
  // shrinking the whole momentum does not cure it: the axis outweighs what grows across it
  EXPECT_NEAR(transverse_growth("momentum_clamped_explicit", h), explicit_growth, 1e-5);
  // the splitting turns about one axis at a time, so the rate breathes, but after an hour it is what it was
  for (const long steps : {1, 100, 216'000}) {
    EXPECT_NEAR(transverse_growth("rigid_body_splitting", h, steps), 1, 0.1) << steps;
  }
  // at 1 kHz the explicit term still blows the rod up, 3.5 times a second
  EXPECT_NEAR(transverse_growth("exponential_map", 1e-3, 1000), std::pow(1 + 2.5e-3, 500), 0.01);
}

TEST(Rotation, AFlippingBoxLosesItsSpinToTheImplicitStep) {
  // a box about its middle axis, 5 rad/s at 60 Hz for a minute
  const auto problem = suite_problem("free_rigid_body", "w1=0.05,w2=5,w3=0.05,t_end=60");
  for (const char* id : {"buss2", "rigid_body_splitting", "rkmk4"}) {
    const Drift d = drift(suite_method(id), problem, 3600);
    EXPECT_LT(d.energy, 0.02) << id;
    EXPECT_LT(d.momentum_length, 1e-3) << id;
  }
  EXPECT_GT(drift(suite_method("implicit_gyroscopic"), problem, 3600).momentum_length, 0.3);
}

/// Turns as if the angular velocity were given in space: the product of quaternions the wrong way round.
struct TurnsInSpace {
  template <class Body, class Real>
  void operator()(Body& body, Real t, Real h, Turning<Real>& s) const {
    const Quaternion<Real> start = s.q;
    rigid_body_splitting.step(body, t, h, s);
    s.q = rotation_by(h * s.w) * start;
  }
};
/// The splitting with the torque at the start of the step, where it is not centred.
struct EarlyTorque {
  template <class Body, class Real>
  void operator()(Body& body, Real t, Real h, Turning<Real>& s) const {
    rigid_body_splitting.step(body, t - h / Real(2), h, s);
  }
};
inline constexpr RotationStep<TurnsInSpace> turns_in_space{
    .id = "turns_in_space", .source = "planted", .order = 2};
inline constexpr RotationStep<EarlyTorque> early_torque{
    .id = "early_torque", .source = "planted", .order = 2};

double order_between(const AnyMethod& method, const AnyProblem& problem, long steps) {
  const auto end = fine_end(problem, 256);
  return std::log2(scaled_gap(problem, solve(method, problem, FixedSteps{steps}).y, end) /
                   scaled_gap(problem, solve(method, problem, FixedSteps{2 * steps}).y, end));
}

TEST(Rotation, PlantedFaultsShow) {
  const auto top = probe::problem<probe::DrivenTop>();
  EXPECT_NEAR(order_between(suite_method("rigid_body_splitting"), top, 128), 2, 0.05);
  EXPECT_LT(order_between(erase_method<early_torque>(), top, 128), 1.2);
  const auto free = suite_problem("free_rigid_body_tumbling", "t_end=10");
  EXPECT_LT(drift(suite_method("rigid_body_splitting"), free, 500).momentum_in_space, 1e-12);
  EXPECT_GT(drift(erase_method<turns_in_space>(), free, 500).momentum_in_space, 0.1);
}

TEST(Rotation, TorquesAreCounted) {
  const auto problem = probe::problem<probe::DrivenTop>();
  const std::pair<const char*, long> torques[] = {{"quaternion_euler_normalised", 1},
                                                  {"exponential_map", 1},
                                                  {"implicit_gyroscopic", 1},
                                                  {"momentum_clamped_explicit", 1},
                                                  {"rigid_body_splitting", 1},
                                                  {"buss2", 2},
                                                  {"rkmk4", 4}};
  RunRequest request;
  request.steps = 10, request.trajectory = false;
  for (const auto& [id, a_step] : torques) {
    const Row row = run(suite_method(id), problem, request, "rotation");
    EXPECT_EQ(row.status, "reached_end") << id;
    EXPECT_EQ(row.work.evaluations, 10 * a_step) << id;
    EXPECT_EQ(row.work.rhs, 0) << id;
  }
}

}  // namespace
}  // namespace odemark::rotation_test
