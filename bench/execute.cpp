#include "bench/execute.hpp"

#include <algorithm>
#include <exception>
#include <map>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

namespace odemark {

namespace {

/// Runs f(i) for every i below `count` on `jobs` threads; rethrows the first exception.
void in_parallel(std::size_t count, int jobs, const std::function<void(std::size_t)>& f) {
  std::atomic<std::size_t> next{0};
  std::exception_ptr failure;
  std::mutex failure_mutex;
  const auto work = [&] {
    for (std::size_t i = next++; i < count; i = next++) {
      try {
        f(i);
      } catch (...) {
        const std::lock_guard lock(failure_mutex);
        if (!failure) failure = std::current_exception();
        next = count;
      }
    }
  };
  std::vector<std::jthread> threads;
  for (int j = 1; j < jobs; ++j) threads.emplace_back(work);
  work();
  threads.clear();
  if (failure) std::rethrow_exception(failure);
}

/// What the runs so far say about those to come; see execute.hpp.
class Comparison {
 public:
  bool hopeless(const PlannedRun& run) const {
    return run.part_of_comparison && out_of_time_.contains({run.problem->id, run.method->id});
  }
  /// In place of a run that is not worth its time.
  Row not_tried(const PlannedRun& planned) const {
    Row row = describe(*planned.method, *planned.problem, planned.request, planned.plan);
    row.status = out_of_time_.at({planned.problem->id, planned.method->id});
    row.reason = "not tried: ran out of time or steps at a looser tolerance";
    return row;
  }
  void prepare(const PlannedRun& run, RunRequest& request) const {
    if (!run.part_of_comparison) return;
    if (const auto best = fastest_.find(cell(run)); best != fastest_.end())
      request.timed_once_from = std::min(request.timed_once_from, 10 * best->second);
  }
  void learn(const PlannedRun& run, const Row& row) {
    if (!run.part_of_comparison) return;
    if (row.status == to_string(RunStatus::time_limit) || row.status == to_string(RunStatus::step_limit))
      out_of_time_.emplace(std::pair{run.problem->id, run.method->id}, row.status);
    if (row.timing) {
      const double seconds = row.timing->minimum_seconds;
      const auto [best, is_new] = fastest_.emplace(cell(run), seconds);
      if (!is_new && seconds < best->second) best->second = seconds;
    }
  }

 private:
  using Cell = std::pair<std::string, double>;
  static Cell cell(const PlannedRun& run) { return {run.problem->id, run.request.rtol.value_or(0)}; }

  std::map<std::pair<std::string, std::string_view>, std::string> out_of_time_;  // and by which status
  std::map<Cell, double> fastest_;                                               // by problem and tolerance
};

}  // namespace

bool execute(const std::vector<PlannedRun>& plan, const ExecuteOptions& options) {
  std::vector<const PlannedRun*> wanted;
  for (const auto& planned : plan)
    if (!options.done.contains(row_id(*planned.method, *planned.problem, planned.request, planned.plan)))
      wanted.push_back(&planned);
  const auto stopped = [&] { return options.stop && options.stop->load(); };
  const std::size_t already = plan.size() - wanted.size();
  // a block is long enough to keep the threads busy and short enough to lose little when interrupted
  const std::size_t block_size = options.jobs > 1 ? 64 : 1;
  Comparison comparison;
  for (std::size_t begin = 0; begin < wanted.size(); begin += block_size) {
    const std::size_t count = std::min(block_size, wanted.size() - begin);
    std::vector<std::optional<Row>> rows(count);
    const auto error_part = [&](std::size_t i) {
      if (stopped()) return;
      const PlannedRun& planned = *wanted[begin + i];
      RunRequest request = planned.request;
      if (options.jobs > 1) request.timing_repeats = 0;
      if (comparison.hopeless(planned)) {
        rows[i] = comparison.not_tried(planned);
        return;
      }
      comparison.prepare(planned, request);
      rows[i] = run(*planned.method, *planned.problem, request, planned.plan, options.stop);
    };
    in_parallel(count, options.jobs, error_part);
    for (std::size_t i = 0; i < count; ++i) {
      const PlannedRun& planned = *wanted[begin + i];
      if (options.jobs > 1 && planned.request.timing_repeats > 0 && !stopped() && rows[i]) {
        RunRequest request = planned.request;
        comparison.prepare(planned, request);
        add_timing(*rows[i], *planned.method, *planned.problem, request);
      }
      // a run that was cut short by the stop is no result
      if (stopped() || !rows[i]) return false;
      comparison.learn(planned, *rows[i]);
      if (options.progress) options.progress(already + begin + i + 1, plan.size(), rows[i]->id);
      if (options.sink) options.sink(*rows[i]);
    }
  }
  return true;
}

}  // namespace odemark
