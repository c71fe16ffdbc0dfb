#include "bench/static_run.hpp"

#include <algorithm>

#include "reference/contestants.hpp"

namespace odemark {

const StaticRun* find_static_run(std::string_view family, std::string_view method) {
  static const std::vector<StaticRun> runs = [] {
    std::vector<StaticRun> all = suite_static_runs();
    if (!all.empty())  // without a static tier nobody is inlined
      for (const auto& c : inlined_contestants()) all.push_back({c.family, c.method, c.solve});
    return all;
  }();
  const auto found = std::find_if(
      runs.begin(), runs.end(), [&](const StaticRun& r) { return r.family == family && r.method == method; });
  return found == runs.end() ? nullptr : &*found;
}

}  // namespace odemark
