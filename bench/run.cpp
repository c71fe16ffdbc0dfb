#include "bench/run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "bench/measure.hpp"
#include "bench/solve.hpp"
#include "bench/static_run.hpp"
#include "bench/step_record.hpp"

namespace odemark {

namespace {

Control control_of(const RunRequest& request, const AnyProblem& problem) {
  if (request.steps) return FixedSteps{*request.steps, request.compensated};
  ErrorControl control{*request.rtol, request.atol.value_or(*request.rtol), request.filter};
  control.first_step = request.first_step.value_or(0);
  control.step_limit = request.step_limit;
  control.scale = problem.scale.data();
  return control;
}

/// Why the pair cannot run this request; empty where it can.
template <class T>
std::string_view obstacle(const AnyMethod& method, const AnyProblem& problem, const RunRequest& request) {
  if (const auto missing = missing_ability(method.needs, problem.abilities); !missing.empty()) return missing;
  if (!method.runs<T>().solve_traced) return "computes in double precision only";
  if (request.steps && !method.takes_fixed_steps) return "chooses its own steps: give a tolerance";
  if (request.rtol && !method.takes_error_control)
    return "has no error estimate: give a fixed number of steps";
  if (request.compensated && !method.compensated) return "has no compensated summation";
  return "";
}

template <class T>
std::vector<T> initial_state(const AnyProblem& problem) {
  std::vector<T> y(problem.initial.size());
  for (std::size_t i = 0; i < y.size(); ++i) y[i] = static_cast<T>(problem.initial[i]);
  return y;
}

/// Runs again bare, timed, in batches long enough for the clock; every batch must end in the same bits.
template <class T>
RowTiming time_runs(const AnyMethod& method, const AnyProblem& problem, const RunRequest& request,
                    const Control& control, const Row& row) {
  using Clock = std::chrono::steady_clock;
  const StaticRun* inlined = nullptr;
  const bool pieces = in_pieces(problem, control);
  if constexpr (std::is_same_v<T, double>)
    if (!pieces && !request.compensated && (request.rtol || method.provider == "odemark"))
      inlined = find_static_run(problem.family, method.id);
  Trace<T> nothing;
  std::vector<FoundEvent> found;
  const auto initial = initial_state<T>(problem);
  std::vector<T> y = initial;
  const auto once = [&] {
    std::copy(initial.begin(), initial.end(), y.begin());
    if constexpr (std::is_same_v<T, double>)
      if (inlined) {
        inlined->solve(problem.value.get(), control, problem.t_begin, problem.t_end, y.data());
        return;
      }
    if (pieces)
      solve_problem(method, problem, control, y, nothing, found, nullptr);
    else
      method.runs<T>().solve(problem.system<T>(), control, problem.t_begin, problem.t_end, y);
  };
  const auto seconds_of = [&](int batch) {
    const auto begin = Clock::now();
    for (int i = 0; i < batch; ++i) once();
    return std::chrono::duration<double>(Clock::now() - begin).count() / batch;
  };
  const double probe = seconds_of(1);
  if (hash_bits(y) != row.state_hash)
    throw std::logic_error(fmt::format("{}: the timed run ended in other bits than the counted run", row.id));
  const int batch = std::clamp(static_cast<int>(20e-6 / std::max(probe, 1e-9)), 1, 1000);
  // a long run is its own average: the one that checked the bits is the measurement
  std::vector<double> seconds;
  const bool long_enough = probe > request.timed_once_from;
  if (long_enough) seconds.push_back(probe);
  double spent = long_enough ? request.timing_seconds : 0;
  while (seconds.empty() || spent < request.timing_seconds ||
         (static_cast<int>(seconds.size()) < request.timing_repeats && spent < 4 * request.timing_seconds)) {
    seconds.push_back(seconds_of(batch));
    spent += seconds.back() * batch;
    if (seconds.size() >= 10'000) break;
  }
  const auto median = [](std::vector<double> v) {
    const auto middle = v.begin() + static_cast<std::ptrdiff_t>(v.size() / 2);
    std::nth_element(v.begin(), middle, v.end());
    return *middle;
  };
  RowTiming timing;
  timing.repeats = static_cast<int>(seconds.size());
  timing.minimum_seconds = *std::min_element(seconds.begin(), seconds.end());
  timing.median_seconds = median(seconds);
  for (double& s : seconds) s = std::abs(s - timing.median_seconds);
  timing.mad_seconds = median(seconds);
  timing.tier = inlined ? "static" : "erased";
  const double steps = static_cast<double>(row.accepted + row.rejected);
  timing.ns_per_step = steps > 0 ? 1e9 * timing.minimum_seconds / steps : 0;
  timing.ns_per_simulated_second = 1e9 * timing.minimum_seconds / (problem.t_end - problem.t_begin);
  return timing;
}

RowEvents event_errors(const std::vector<FoundEvent>& found, const std::vector<TruthEvent>& expected) {
  RowEvents events{long(found.size()), long(expected.size()), {}};
  for (std::size_t i = 0; i < std::min(found.size(), expected.size()); ++i) {
    if (found[i].event != expected[i].event) break;  // from here on it is another story
    const double error = double(std::abs(difference(static_cast<long double>(found[i].t), expected[i].t)));
    events.worst_time_error = std::max(events.worst_time_error.value_or(0), error);
  }
  return events;
}

void add_errors(Row& row, const AnyProblem& problem, const std::vector<long double>& y,
                const std::vector<long double>& samples, const Watch& watch,
                const std::vector<FoundEvent>& found, double unit_roundoff_ratio) {
  std::shared_ptr<const Truth> truth;
  try {
    truth = truth_of(problem);
  } catch (const TruthUnavailable& e) {
    row.reason = fmt::format("no error: {}", e.what());
    return;
  }
  const TruthPoint& end = truth->last();
  if (!problem.event_names.empty()) row.events = event_errors(found, truth->events);
  for (std::size_t p = 0; p < end.values.size(); ++p)
    row.truth_floor =
        std::max(row.truth_floor,
                 double(end.values[p].bound) / problem.scale[truth->places.empty() ? p : truth->places[p]]);
  row.truth_digits = end.digits;
  row.sensitivity = end.sensitivity * unit_roundoff_ratio;
  if (row.status != "reached_end") return;
  row.errors = errors_at_end(problem, *truth, y);
  if (!samples.empty()) add_trajectory_errors(*row.errors, problem, *truth, samples);
  if (const auto o = watch.oscillation()) {
    std::vector<double> exact;
    for (const auto& v : end.values) exact.push_back(double(v.hi));
    const Oscillation right = problem.oscillation_call(problem.value.get(), exact.data());
    const Oscillation start = problem.oscillation_call(problem.value.get(), problem.initial.data());
    const double expected = start.phase + right.rate * (problem.t_end - problem.t_begin);
    row.errors->amplitude = o->amplitude / right.amplitude - 1;
    row.errors->phase = o->phase - (expected + std::remainder(right.phase - expected, 2 * std::acos(-1.0)));
  }
}

template <class T>
void run_as(Row& row, const AnyMethod& method, const AnyProblem& problem, const RunRequest& request,
            const std::atomic<bool>* stop) {
  if (const auto reason = obstacle<T>(method, problem, request); !reason.empty()) {
    row.status = "not_applicable";
    row.reason = std::string(reason);
    return;
  }
  const Control control = control_of(request, problem);
  auto y = initial_state<T>(problem);
  WorkCounts counts;
  Watch watch(problem, request.time_limit_seconds);
  std::vector<long double> wide(problem.size());
  Trace<T> trace;
  // sixteen states of a large problem would be most of the memory of the run, and its truth knows the end
  if (request.trajectory && !problem.is_large()) trace.grid = common_times(problem);
  std::optional<StepRecord> record;
  // it keeps the state of every step
  if (request.rtol && (request.step_sizes || request.local_errors) && !problem.is_large())
    record.emplace(problem, std::vector<long double>(y.begin(), y.end()));
  double last_finite = problem.t_begin;  // fixed steps go on through NaN: where the numbers ended
  trace.on_step = [&](T t, const T* state) {
    std::copy_n(state, wide.size(), wide.begin());
    if (all_finite(wide)) last_finite = static_cast<double>(t);
    if (record) record->add(t, wide);
    return watch(wide) && !(stop && stop->load(std::memory_order_relaxed));
  };
  RunReport report;
  std::vector<FoundEvent> found;
  try {
    report = solve_problem(method, problem, control, y, trace, found, &counts);
  } catch (const std::exception& e) {
    row.status = to_string(RunStatus::rhs_failed);
    row.reason = fmt::format("the right-hand side threw: {}", e.what());
    row.t_reached = last_finite;
    return;
  }
  row.status = to_string(report.status);
  row.reason = std::string(report.reason);
  row.accepted = report.accepted, row.rejected = report.rejected, row.t_reached = report.t_reached;
  if (report.status == RunStatus::not_finite) row.t_reached = std::min(report.t_reached, last_finite);
  row.work = {counts.rhs,
              counts.acceleration,
              counts.jacobian,
              counts.series,
              report.newton.lu,
              report.newton.newton,
              counts.rhs + counts.acceleration + counts.series * method.order};
  row.state_hash = hash_bits(y);
  if (record && request.step_sizes) row.history = record->history(64);
  // a step is judged by the equations it was taken with; a record does not know their phase
  if (record && request.local_errors && problem.smooth())
    row.local = record->local_errors(std::get<ErrorControl>(control), 48);
  watch.fill(row);
  std::copy(y.begin(), y.end(), wide.begin());
  const std::vector<long double> samples(trace.samples.begin(), trace.samples.end());
  const double roundoff = double(std::numeric_limits<T>::epsilon()) / std::numeric_limits<double>::epsilon();
  add_errors(row, problem, wide, samples, watch, found, roundoff);
}

}  // namespace

void add_timing(Row& row, const AnyMethod& method, const AnyProblem& problem, const RunRequest& request) {
  if (row.status != to_string(RunStatus::reached_end)) return;
  const Control control = control_of(request, problem);
  switch (request.scalar) {
    case ScalarType::float_type: row.timing = time_runs<float>(method, problem, request, control, row); break;
    case ScalarType::double_type:
      row.timing = time_runs<double>(method, problem, request, control, row);
      break;
    case ScalarType::long_double_type:
      row.timing = time_runs<long double>(method, problem, request, control, row);
      break;
  }
}

Row run(const AnyMethod& method, const AnyProblem& problem, const RunRequest& request, std::string_view plan,
        const std::atomic<bool>* stop) {
  if (request.steps.has_value() == request.rtol.has_value())
    throw std::logic_error("a request has either a number of steps or a tolerance");
  Row row = describe(method, problem, request, plan);
  switch (request.scalar) {
    case ScalarType::float_type: run_as<float>(row, method, problem, request, stop); break;
    case ScalarType::double_type: run_as<double>(row, method, problem, request, stop); break;
    case ScalarType::long_double_type: run_as<long double>(row, method, problem, request, stop); break;
  }
  if (request.timing_repeats > 0) add_timing(row, method, problem, request);
  return row;
}

}  // namespace odemark
