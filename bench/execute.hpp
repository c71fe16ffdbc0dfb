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

/// True if everything ran, false if it was stopped; the row under way is then dropped, never half written.
bool execute(const std::vector<PlannedRun>& plan, const ExecuteOptions& options);

}  // namespace odemark
