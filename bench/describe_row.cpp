// What was asked for, as a row has it before anything ran.
#include <fmt/format.h>

#include "bench/expected_order.hpp"
#include "bench/run.hpp"

namespace odemark {

std::string_view to_string(ScalarType scalar) {
  switch (scalar) {
    case ScalarType::float_type: return "float";
    case ScalarType::double_type: return "double";
    case ScalarType::long_double_type: return "long_double";
  }
  return "unknown";
}

std::string_view to_string(RunStatus status) {
  switch (status) {
    case RunStatus::reached_end: return "reached_end";
    case RunStatus::step_limit: return "step_limit";
    case RunStatus::step_underflow: return "step_underflow";
    case RunStatus::not_finite: return "not_finite";
    case RunStatus::newton_diverged: return "newton_diverged";
    case RunStatus::time_limit: return "time_limit";
    case RunStatus::rhs_failed: return "rhs_failed";
    case RunStatus::solver_failed: return "solver_failed";
    case RunStatus::not_applicable: return "not_applicable";
  }
  return "unknown";
}

std::string row_id(const AnyMethod& method, const AnyProblem& problem, const RunRequest& request,
                   std::string_view plan) {
  std::string control =
      request.steps ? fmt::format("steps={}", *request.steps) : fmt::format("rtol={:g}", *request.rtol);
  if (request.atol) control += fmt::format(",atol={:g}", *request.atol);
  if (request.first_step) control += fmt::format(",first_step={:g}", *request.first_step);
  if (request.rtol && request.filter.id != default_filter.id)
    control += fmt::format(",filter={}", request.filter.id);
  return fmt::format("{}/{}/{}/{}{}/{}", plan, problem.id, method.id, to_string(request.scalar),
                     request.compensated ? "+compensated" : "", control);
}

Row describe(const AnyMethod& method, const AnyProblem& problem, const RunRequest& request,
             std::string_view plan) {
  Row row;
  row.id = row_id(method, problem, request, plan);
  row.plan = std::string(plan);
  row.problem = problem.id, row.family = std::string(problem.family), row.settings = problem.user_settings;
  row.method = std::string(method.id), row.kind = std::string(method.kind),
  row.provider = std::string(method.provider);
  row.order = method.order, row.embedded_order = method.embedded_order;
  if (request.steps)  // the theory of a method takes a while: not for rows that have no order
    if (const auto expected = expected_order(method, problem); !expected.reason.empty())
      row.expected_order = expected.order, row.expected_because = std::string(expected.reason);
  row.scalar = std::string(to_string(request.scalar));
  row.compensated = request.compensated;
  row.steps = request.steps;
  row.t_end = problem.t_end;
  if (request.steps) row.dt = (problem.t_end - problem.t_begin) / static_cast<double>(*request.steps);
  if (request.rtol) {
    row.rtol = request.rtol, row.atol = request.atol.value_or(*request.rtol);
    row.filter =
        method.provider == "odemark" && !method.own_step_control ? std::string(request.filter.id) : "its own";
  }
  return row;
}

}  // namespace odemark
