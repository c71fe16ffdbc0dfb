// The same request ends in the same bits: run twice, in either order, traced or bare, on one thread or many.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <thread>

#include "bench/json_line.hpp"
#include "bench/measure.hpp"
#include "tests/support/runs.hpp"

namespace odemark::determinism_test {
namespace {

RunRequest request_of(const AnyMethod& method) {
  RunRequest request;
  if (method.takes_fixed_steps)
    request.steps = 48;
  else
    request.rtol = 1e-3;
  return request;
}

std::vector<std::string> rows_of(const AnyProblem& problem, bool backwards) {
  std::vector<std::string> lines;
  auto methods = suite_methods();
  if (backwards) std::reverse(methods.begin(), methods.end());
  for (const auto& method : methods)
    lines.push_back(to_json_line(run(method, problem, request_of(method), "determinism")));
  if (backwards) std::reverse(lines.begin(), lines.end());
  return lines;
}

TEST(Determinism, ARunKnowsNothingOfTheOnesBefore) {
  for (const char* id : {"pendulum", "lorenz63", "stiff_spring_k1e4"}) {
    const auto problem = suite_problem(id);
    EXPECT_EQ(rows_of(problem, false), rows_of(problem, true)) << id;
  }
}

TEST(Determinism, AProblemMadeTwiceIsTheSameProblem) {
  const auto a = suite_problem("damped_spring", "k=6e5,m=168,zeta=0.1"),
             b = suite_problem("damped_spring", "k=6e5,m=168,zeta=0.1");
  for (const auto& method : suite_methods())
    EXPECT_EQ(to_json_line(run(method, a, request_of(method), "d")),
              to_json_line(run(method, b, request_of(method), "d")));
}

TEST(Determinism, ThreadsDoNotDisturbEachOther) {
  const auto problem = suite_problem("pendulum");
  const auto alone = rows_of(problem, false);
  std::vector<std::vector<std::string>> together(4);
  {
    std::vector<std::jthread> threads;
    for (auto& lines : together) threads.emplace_back([&] { lines = rows_of(problem, false); });
  }
  for (const auto& lines : together) EXPECT_EQ(lines, alone);
}

TEST(Determinism, WatchingARunDoesNotChangeIt) {
  for (const char* id : {"pendulum", "lorenz63"}) {
    const auto problem = suite_problem(id);
    for (const auto& method : suite_methods()) {
      if (!can_run<double>(method, problem)) continue;
      RunRequest request = request_of(method);
      const Row traced = run(method, problem, request, "d");
      request.trajectory = false;
      const Row untraced = run(method, problem, request, "d");
      const Control control = request.steps ? Control(FixedSteps{*request.steps}) : [&] {
        ErrorControl c{*request.rtol, *request.rtol};
        c.scale = problem.scale.data();
        return Control(c);
      }();
      EXPECT_EQ(traced.state_hash, untraced.state_hash) << method.id;
      EXPECT_EQ(traced.work.evaluations, untraced.work.evaluations) << method.id;
      EXPECT_EQ(traced.state_hash, hash_bits(solve(method, problem, control).y)) << method.id;
    }
  }
}

TEST(Determinism, TheHashSeesEveryBitOfANumber) {
  const std::vector<double> y{1, 2};
  EXPECT_EQ(hash_bits(y), hash_bits(std::vector<double>{1, 2}));
  EXPECT_NE(hash_bits(y), hash_bits(std::vector<double>{2, 1}));
  EXPECT_NE(hash_bits(y), hash_bits(std::vector<double>{1, std::nextafter(2.0, 3.0)}));
  EXPECT_NE(hash_bits(std::vector<double>{0.0}), hash_bits(std::vector<double>{-0.0}));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(hash_bits(std::vector<double>{nan}), hash_bits(std::vector<double>{-nan}));
  EXPECT_NE(hash_bits(std::vector<double>{nan}), hash_bits(std::vector<double>{INFINITY}));
  EXPECT_EQ(hash_bits(std::vector<double>{}), "cbf29ce484222325");
  EXPECT_EQ(hash_bits(y).size(), 16u);
}

}  // namespace
}  // namespace odemark::determinism_test
