// One run of one method on one problem: counted, compared with the truth, timed. One request gives all of it.
#pragma once

#include <atomic>
#include <optional>
#include <string>
#include <string_view>

#include "bench/data/row.hpp"
#include "integrators/any_method.hpp"
#include "reference/any_problem.hpp"

namespace odemark {

enum class ScalarType { float_type, double_type, long_double_type };

std::string_view to_string(ScalarType scalar);
std::string_view to_string(RunStatus status);

struct RunRequest {
  std::optional<long> steps;   // fixed steps, or ...
  std::optional<double> rtol;  // ... error control with atol = rtol (in units of the problem's scale) ...
  std::optional<double> atol;  // ... unless given
  std::optional<double> first_step;
  StepFilter filter = default_filter;
  ScalarType scalar = ScalarType::double_type;
  bool compensated = false;
  int timing_repeats = 0;          // 0: do not time
  double timing_seconds = 0.02;    // repeat until this much time is spent, at least timing_repeats times
  double timed_once_from = 0.05;   // seconds: a run this long is its own average and is not repeated
  double time_limit_seconds = 20;  // of the counted run
  long step_limit = 10'000'000;    // under error control
  bool trajectory = true;          // compare on the common time grid too
  bool step_sizes = false;         // error control: keep the history of the step
  bool local_errors = false;  // error control: compare single steps with the solution through their start
};

/// Never throws for numerical reasons: a failed run is a row with its status. Throws std::logic_error if the
/// timed run computed something else than the counted one: that is a bug of ours, not a result. `stop` ends
/// it early.
Row run(const AnyMethod& method, const AnyProblem& problem, const RunRequest& request, std::string_view plan,
        const std::atomic<bool>* stop = nullptr);

/// Times a row that was run without: the same request again, bare. Nothing happens to a row that did not
/// reach its end.
void add_timing(Row& row, const AnyMethod& method, const AnyProblem& problem, const RunRequest& request);

/// The row as it is before anything ran: what was asked for.
Row describe(const AnyMethod& method, const AnyProblem& problem, const RunRequest& request,
             std::string_view plan);

/// The row's identity, without running: what a results file is resumed by.
std::string row_id(const AnyMethod& method, const AnyProblem& problem, const RunRequest& request,
                   std::string_view plan);

}  // namespace odemark
