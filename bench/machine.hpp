// What this binary is and where it runs: the first line of every results file.
#pragma once

#include <string>

#include "bench/data/row.hpp"

namespace odemark {

/// Compiler, flags and build type of the measured code; processor, cores and system of this machine; versions
/// of the third-party solvers; footnotes for what affects their numbers. The date is UTC.
RunHeader describe_machine();

/// "odemark 0.1.0  g++ 12.2 -O3 -ffp-contract=off  sundials 6.4.1  gsl 2.7.1  2 cores".
std::string headline(const RunHeader& header);

/// "odemark 0.1.0 (v0.1.0-3-gabc)".
std::string version_text();

}  // namespace odemark
