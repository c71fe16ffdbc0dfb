// odemark bench: the Google Benchmark binary under the suite's own name.
#include <fmt/format.h>

#include "bench/cli/commands.hpp"
#ifdef ODEMARK_HAS_BENCHMARK
#include "bench/step_cost/step_cost.hpp"
#endif

namespace odemark {

int bench_command(const std::vector<std::string>& arguments) {
#ifdef ODEMARK_HAS_BENCHMARK
  return step_cost_main(arguments, suite_registry());
#else
  (void)arguments;
  fmt::print(
      stderr,
      "odemark: this binary was built without Google Benchmark: install libbenchmark-dev and build again\n");
  return exit_usage;
#endif
}

}  // namespace odemark
