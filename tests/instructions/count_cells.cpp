// Runs every loop of the step cost for N and for 2N steps under callgrind, one dump each: the difference is N
// steps.
#include <valgrind/callgrind.h>

#include <cstdio>
#include <cstdlib>

#include "bench/step_cost/tax.hpp"
#include "tests/instructions/planted_loop.hpp"

namespace {

constexpr long steps = 1000;

void count(const std::string& name, const std::function<double(long)>& loop) {
  if (!loop) return;
  double sum = loop(2 * steps);  // what happens once, like binding symbols, happens here
  for (const long n : {steps, 2 * steps}) {
    const std::string label =
        name + "/" + std::to_string(n);  // must outlive the macro, which keeps its address
    CALLGRIND_ZERO_STATS;
    sum += loop(n);
    CALLGRIND_DUMP_STATS_AT(label.c_str());
  }
  std::printf("%s %.17g\n", name.c_str(), sum);
}

}  // namespace

/// Without arguments the suite's loops; with "planted" the ones that must be found too slow.
int main(int argc, char**) {
  if (!RUNNING_ON_VALGRIND) {
    std::fprintf(stderr, "run it by: valgrind --tool=callgrind %s\n", "odemark_count_cells");
    return 2;
  }
  for (auto cell : odemark::tax_cells()) {
    const std::string name = cell.problem + "/" + cell.method;
    if (argc > 1) {
      if (name != "oscillator/rk4") continue;
      cell.engine = odemark::planted_loop();
    }
    count(name + "/hand", cell.hand);
    count(name + "/engine", cell.engine);
    if (argc == 1) count(name + "/odeint", cell.odeint);
  }
}
