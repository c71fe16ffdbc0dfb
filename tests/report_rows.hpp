// Rows with known answers, for tests of reports.
#pragma once

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "bench/data/row.hpp"
#include "bench/data/stability.hpp"

namespace odemark {

inline constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// One run with `error` = constant * dt^order on a ladder of halved steps.
inline Row fixed_row(const std::string& problem, const std::string& method, int order, long steps,
                     double error) {
  Row row;
  row.plan = "convergence", row.problem = problem, row.family = problem, row.method = method;
  row.kind = "explicit Runge-Kutta", row.provider = "odemark", row.scalar = "double";
  row.order = order, row.steps = steps, row.dt = 10.0 / static_cast<double>(steps),
  row.t_end = row.t_reached = 10;
  row.id = "convergence/" + problem + "/" + method + "/double/steps=" + std::to_string(steps);
  row.status = "reached_end", row.accepted = steps, row.work.evaluations = row.work.rhs = steps * order;
  row.errors = RowErrors{};
  row.errors->scaled = error;
  row.truth_floor = 1e-25;
  return row;
}

inline std::vector<Row> ladder(const std::string& problem, const std::string& method, int order) {
  std::vector<Row> rows;
  for (long steps = 16; steps <= 4096; steps *= 2)
    rows.push_back(fixed_row(problem, method, order, steps, 0.1 * std::pow(10.0 / double(steps), order)));
  return rows;
}

inline void append(std::vector<Row>& rows, const std::vector<Row>& more) {
  rows.insert(rows.end(), more.begin(), more.end());
}

inline Row failed_row(const std::string& problem, const std::string& method, long steps,
                      const std::string& status) {
  Row row = fixed_row(problem, method, 1, steps, 0);
  row.errors.reset();
  row.status = status, row.reason = "y[0] is not finite", row.t_reached = 2.5;
  return row;
}

inline StabilityRow limit_row(double measured, double theory) {
  StabilityRow row;
  row.problem = "p", row.method = "rk4", row.verdict = row.theory_verdict = "limit";
  row.measured = measured, row.theory = theory, row.difference = measured - theory;
  row.resolution = 1e-9, row.fastest_rate = 1;
  return row;
}

}  // namespace odemark
