// Good rows to plant faults in: a gate must be quiet on these and bite on every fault.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "reports/check.hpp"

namespace odemark {

inline Row good_run(const std::string& problem, const std::string& method, int order, long steps) {
  Row row;
  row.id = "convergence/" + problem + "/" + method + "/double/steps=" + std::to_string(steps);
  row.plan = "convergence", row.problem = problem, row.method = method;
  row.provider = "odemark", row.scalar = "double", row.order = order;
  row.steps = steps, row.dt = 10.0 / static_cast<double>(steps);
  row.status = "reached_end", row.accepted = steps, row.t_end = row.t_reached = 10;
  row.work.rhs = row.work.evaluations = steps * order;
  const double error = 0.1 * std::pow(*row.dt, order);
  RowErrors& errors = row.errors.emplace();
  errors.scaled = errors.absolute = errors.rms = error;
  errors.relative = errors.trajectory_max = errors.trajectory_rms = error;
  row.drift["energy"] = error / 2;
  row.state_hash = "00000000000000" + std::to_string(10 + steps % 90);
  return row;
}

inline std::vector<Row> good_ladder(const std::string& problem, const std::string& method, int order) {
  std::vector<Row> rows;
  for (long steps = 16; steps <= 1024; steps *= 2) rows.push_back(good_run(problem, method, order, steps));
  return rows;
}

inline std::vector<Row> good_rows() {
  std::vector<Row> rows = good_ladder("kepler", "rk4", 4);
  for (const auto& more : {good_ladder("kepler", "heun", 2), good_ladder("oscillator", "rk4", 4)})
    rows.insert(rows.end(), more.begin(), more.end());
  Row adaptive = good_run("kepler", "dormand_prince54", 5, 400);
  adaptive.id = "work_precision/kepler/dormand_prince54/double/rtol=1e-06";
  adaptive.steps.reset(), adaptive.dt.reset(), adaptive.rtol = adaptive.atol = 1e-6;
  rows.push_back(adaptive);
  return rows;
}

/// The run of a case with that many steps.
inline Row& run_of(std::vector<Row>& rows, const std::string& problem, const std::string& method,
                   long steps) {
  return *std::find_if(rows.begin(), rows.end(), [&](const Row& row) {
    return row.problem == problem && row.method == method && row.steps == steps;
  });
}

inline StabilityRow good_limit(const std::string& method, const std::string& verdict, double limit) {
  StabilityRow row;
  row.problem = "oscillator", row.method = method, row.provider = "odemark";
  row.verdict = row.theory_verdict = verdict;
  if (verdict == "limit") row.measured = row.theory = limit;
  row.resolution = 1e-12;
  return row;
}

inline CheckResult gate(const std::vector<Row>& rows, const std::string& rules,
                        const std::vector<StabilityRow>& stability = {}, const CheckOptions& options = {}) {
  return check(rows, stability, parse_thresholds("schema = 1\n" + rules), {}, {}, options);
}

/// What the gate says of one case and metric; a pass where it says nothing.
inline Finding finding_of(const CheckResult& result, const std::string& name, const std::string& metric) {
  for (const Finding& finding : result.findings)
    if (finding.case_name == name && finding.metric == metric) return finding;
  return {};
}

}  // namespace odemark
