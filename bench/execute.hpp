// Runs a plan: the errors in parallel, the times strictly one after another, the rows in the plan's order.
#pragma once

#include <atomic>
#include <functional>
#include <set>

#include "bench/plan.hpp"

namespace odemark {

struct ExecuteOptions {
  int jobs = 1;
  std::set<std::string> done;               // row ids that a resumed file has already
  const std::atomic<bool>* stop = nullptr;  // set by Ctrl-C
  std::function<void(const Row&)> sink;     // every finished row, in the plan's order
  std::function<void(std::size_t done, std::size_t total, const std::string& what)> progress;
};

/// A plan that compares codes would spend its time on those that are far behind. There a method that ran out
/// of time or steps is not run at the finer tolerances of the same problem: those rows say so. And a run ten
/// times as long as the fastest so far at its tolerance is timed once. Neither changes who is fastest.
///
/// True if everything ran, false if it was stopped; the row under way is then dropped, never half written.
bool execute(const std::vector<PlannedRun>& plan, const ExecuteOptions& options);

}  // namespace odemark
