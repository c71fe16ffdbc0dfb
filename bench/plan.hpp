// A plan is data: which methods on which problems under which controls. A suite is a few plans.
#pragma once

#include <string>
#include <vector>

#include "bench/registry.hpp"
#include "bench/run.hpp"

namespace odemark {

struct PlannedRun {
  const AnyMethod* method;
  std::shared_ptr<const AnyProblem> problem;
  RunRequest request;
  std::string plan;
  bool part_of_comparison = false;  // codes against codes at one tolerance; see execute.hpp
};

/// What `odemark run` was asked for. Empty lists mean: what the suite says.
struct PlanOptions {
  std::string suite = "quick";  // quick, standard, full, gate or work_precision
  std::string methods, problems, settings;
  std::vector<double> dts;         // fixed steps: instead of the suite's ladder
  std::vector<double> tolerances;  // error control: instead of the suite's ladder
  std::string filter{default_filter.id};
  std::string scalars = "";  // "float,double,long_double"; empty: what the suite says
  bool compensated = false;
  bool timing = true;
  double time_limit_seconds = 20;
};

std::vector<std::string> suite_names();

/// The options as text: two runs with equal text ask for the same rows.
std::string suite_text(const PlanOptions& options);

/// Every run of the suite, in the order in which rows are written: problem by problem, method by method, from
/// the coarsest control to the finest. Throws BadInput.
std::vector<PlannedRun> make_plan(const Registry& registry, const PlanOptions& options);

/// Counts of equal steps from about eight times the suggested dt downwards, each twice the one before;
/// multiples of 16, so that the common time grid falls on steps. Never empty: where the suggested dt would
/// make more than `most_steps`, the ladder ends there instead.
std::vector<long> step_ladder(const AnyProblem& problem, int rungs, long most_steps = 1L << 24);

}  // namespace odemark
