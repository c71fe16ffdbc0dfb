// Executing a plan: same rows whatever the number of threads, resuming does what is missing, stopping loses
// nothing.
#include "bench/execute.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <thread>

#include "bench/json_line.hpp"
#include "bench/static_run.hpp"
#include "tests/support/probe_families.hpp"
#include "tests/support/runs.hpp"

namespace odemark::execute_test {
namespace {

const std::vector<PlannedRun>& plan() {
  static const Registry registry{suite_methods(), suite_families()};
  static const std::vector<PlannedRun> made = [] {
    PlanOptions options;
    options.methods = "rk4,heun,tsitouras54,stormer_verlet,sdirk2,exponential_euler,taylor8,chapter_*";
    options.problems = "oscillator,pendulum,lorenz63";
    options.timing = false;
    return make_plan(registry, options);
  }();
  return made;
}

std::vector<std::string> lines_of(const ExecuteOptions& base) {
  std::vector<std::string> lines;
  ExecuteOptions options = base;
  options.sink = [&](const Row& row) { lines.push_back(to_json_line(row)); };
  EXPECT_TRUE(execute(plan(), options));
  return lines;
}

const std::vector<std::string>& reference_lines() {
  static const std::vector<std::string> lines = lines_of({});
  return lines;
}

TEST(Execute, RowsComeInTheOrderOfThePlan) {
  ASSERT_EQ(reference_lines().size(), plan().size());
  for (std::size_t i = 0; i < plan().size(); ++i) {
    const auto& p = plan()[i];
    EXPECT_NE(reference_lines()[i].find("\"" + row_id(*p.method, *p.problem, p.request, p.plan) + "\""),
              std::string::npos);
  }
}

TEST(Execute, RowsDoNotDependOnTheNumberOfThreads) {
  for (const int jobs : {1, 2, 7}) {
    ExecuteOptions options;
    options.jobs = jobs;
    EXPECT_EQ(lines_of(options), reference_lines()) << jobs << " threads";
  }
}

TEST(Execute, ResumingRunsExactlyWhatIsMissing) {
  ExecuteOptions options;
  std::vector<std::string> missing;
  for (std::size_t i = 0; i < plan().size(); ++i) {
    const auto& p = plan()[i];
    if (i % 3 == 1)
      missing.push_back(reference_lines()[i]);
    else
      options.done.insert(row_id(*p.method, *p.problem, p.request, p.plan));
  }
  for (const int jobs : {1, 2}) {
    options.jobs = jobs;
    EXPECT_EQ(lines_of(options), missing);
  }
  for (const auto& p : plan()) options.done.insert(row_id(*p.method, *p.problem, p.request, p.plan));
  EXPECT_TRUE(lines_of(options).empty());
}

TEST(Execute, AStopKeepsFinishedRowsAndDropsTheOneUnderWay) {
  for (const int jobs : {1, 2}) {
    std::atomic<bool> stop{false};
    ExecuteOptions options;
    options.jobs = jobs;
    options.stop = &stop;
    std::vector<std::string> lines;
    options.sink = [&](const Row& row) {
      lines.push_back(to_json_line(row));
      if (lines.size() == 70) stop = true;
    };
    EXPECT_FALSE(execute(plan(), options));
    ASSERT_EQ(lines.size(), 70u);
    EXPECT_TRUE(std::equal(lines.begin(), lines.end(), reference_lines().begin()));
  }
}

TEST(Execute, AStopDuringALongRunLeavesNoRow) {
  std::atomic<bool> stop{false};
  const auto problem = std::make_shared<const AnyProblem>(suite_problem("oscillator", "t_end=1e7"));
  RunRequest request;
  request.steps = 400'000'000;
  request.trajectory = false;
  const std::vector<PlannedRun> endless{{&suite_method("rk4"), problem, request, "convergence"}};
  ExecuteOptions options;
  options.stop = &stop;
  int rows = 0;
  options.sink = [&](const Row&) { ++rows; };
  std::jthread interrupter([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    stop = true;
  });
  const auto begin = std::chrono::steady_clock::now();
  EXPECT_FALSE(execute(endless, options));
  EXPECT_EQ(rows, 0);
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(10));
}

TEST(Execute, ProgressCountsWhatWasDoneBefore) {
  ExecuteOptions options;
  for (std::size_t i = 0; i < plan().size(); i += 2) {
    const auto& p = plan()[i];
    options.done.insert(row_id(*p.method, *p.problem, p.request, p.plan));
  }
  std::size_t expected = options.done.size();
  options.progress = [&](std::size_t done, std::size_t total, const std::string& what) {
    EXPECT_EQ(done, ++expected);
    EXPECT_EQ(total, plan().size());
    EXPECT_FALSE(what.empty());
  };
  lines_of(options);
  EXPECT_EQ(expected, plan().size());
}

TEST(Execute, ASinkThatCannotWriteEndsItAll) {
  ExecuteOptions options;
  int rows = 0;
  options.sink = [&](const Row&) {
    if (++rows == 3) throw std::runtime_error("disk full");
  };
  EXPECT_THROW(execute(plan(), options), std::runtime_error);
  EXPECT_EQ(rows, 3);
}

TEST(Execute, TimesAreTakenOfRunsThatReachedTheEnd) {
  static const Registry registry{suite_methods(), suite_families()};
  PlanOptions chosen;
  chosen.methods = "rk4,chapter_adaptive_euler", chosen.problems = "oscillator", chosen.dts = {0.5},
  chosen.tolerances = {1e-2};
  for (const int jobs : {1, 2}) {
    ExecuteOptions options;
    options.jobs = jobs;
    int timed = 0;
    options.sink = [&](const Row& row) {
      ASSERT_TRUE(row.timing.has_value()) << row.id;
      ++timed;
      EXPECT_EQ(row.timing->tier, suite_static_runs().empty() ? "erased" : "static");
      EXPECT_GT(row.timing->minimum_seconds, 0);
      EXPECT_GE(row.timing->median_seconds, row.timing->minimum_seconds);
      EXPECT_GE(row.timing->repeats, 3);
    };
    EXPECT_TRUE(execute(make_plan(registry, chosen), options));
    EXPECT_EQ(timed, 2);
  }
}

TEST(Execute, AComparisonDoesNotWaitForMethodsThatRanOutOfTime) {
  static const Registry registry{suite_methods(), suite_families()};
  PlanOptions chosen;
  chosen.suite = "work_precision";
  chosen.methods = "heun21,rodas4", chosen.problems = "van_der_pol_mu1000", chosen.timing = false;
  std::vector<Row> hopeless, others;
  ExecuteOptions options;
  options.sink = [&](const Row& row) { (row.method == "heun21" ? hopeless : others).push_back(row); };
  const auto runs = make_plan(registry, chosen);
  EXPECT_TRUE(execute(runs, options));
  ASSERT_GE(hopeless.size(), 3u);
  ASSERT_GE(others.size(), 10u);
  EXPECT_EQ(hopeless.size() + others.size(), runs.size());
  EXPECT_EQ(hopeless[0].status, "step_limit");
  EXPECT_GT(hopeless[0].accepted, 0);
  for (std::size_t i = 1; i < hopeless.size(); ++i) {
    EXPECT_EQ(hopeless[i].status, "step_limit");
    EXPECT_EQ(hopeless[i].accepted, 0);
    EXPECT_TRUE(hopeless[i].reason.starts_with("not tried")) << hopeless[i].reason;
    EXPECT_EQ(hopeless[i].rtol, std::pow(10.0, -2.0 - static_cast<double>(i)));
    EXPECT_EQ(hopeless[i].filter, hopeless[0].filter);
  }
  for (const Row& row : others) EXPECT_EQ(row.status, "reached_end") << row.id;
  // without the mark of a comparison everything is run
  auto all = runs;
  for (auto& run : all) run.part_of_comparison = false;
  all.erase(std::remove_if(all.begin(), all.end(), [](const auto& r) { return r.method->id != "heun21"; }),
            all.end());
  all.resize(2);
  hopeless.clear();
  EXPECT_TRUE(execute(all, options));
  EXPECT_GT(hopeless.at(1).accepted, 0);
}

}  // namespace
}  // namespace odemark::execute_test
