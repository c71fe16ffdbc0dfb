#include "bench/execute.hpp"

#include <algorithm>
#include <exception>
#include <mutex>
#include <optional>
#include <thread>

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
  for (std::size_t begin = 0; begin < wanted.size(); begin += block_size) {
    const std::size_t count = std::min(block_size, wanted.size() - begin);
    std::vector<std::optional<Row>> rows(count);
    const auto error_part = [&](std::size_t i) {
      if (stopped()) return;
      const PlannedRun& planned = *wanted[begin + i];
      RunRequest request = planned.request;
      if (options.jobs > 1) request.timing_repeats = 0;
      rows[i] = run(*planned.method, *planned.problem, request, planned.plan, options.stop);
    };
    in_parallel(count, options.jobs, error_part);
    for (std::size_t i = 0; i < count; ++i) {
      const PlannedRun& planned = *wanted[begin + i];
      if (options.jobs > 1 && planned.request.timing_repeats > 0 && !stopped() && rows[i])
        add_timing(*rows[i], *planned.method, *planned.problem, planned.request);
      // a run that was cut short by the stop is no result
      if (stopped() || !rows[i]) return false;
      if (options.progress) options.progress(already + begin + i + 1, plan.size(), rows[i]->id);
      if (options.sink) options.sink(*rows[i]);
    }
  }
  return true;
}

}  // namespace odemark
