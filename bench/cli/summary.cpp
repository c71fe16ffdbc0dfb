// The console table of `odemark run`, of a whole results file.
#include "bench/cli/summary.hpp"

#include "reports/console_summary.hpp"

namespace odemark {

std::string console_summary(const Results& results) {
  return console_summary(results.rows, results.stability);
}

}  // namespace odemark
