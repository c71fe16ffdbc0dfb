#include "bench/static_run.hpp"

#include <algorithm>

namespace odemark {

const StaticRun* find_static_run(std::string_view family, std::string_view method) {
  const auto& runs = suite_static_runs();
  const auto found = std::find_if(
      runs.begin(), runs.end(), [&](const StaticRun& r) { return r.family == family && r.method == method; });
  return found == runs.end() ? nullptr : &*found;
}

}  // namespace odemark
