// The engine's own tax: the suite's steppers beside hand-written loops and Boost.odeint, same flags, same
// run.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace odemark {

/// One cell: the same steps by up to three implementations. Each function advances `count` steps from the
/// start and returns a checksum of where it came to.
struct TaxCell {
  std::string problem, method;
  std::function<double(long count)> hand, engine, odeint;  // odeint is empty where it was not built
};

struct TaxResult {
  std::string problem, method;
  double hand_ns = 0, engine_ns = 0, odeint_ns = 0;     // medians, per step; odeint_ns 0: not measured
  double engine_over_hand = 0, engine_over_odeint = 0;  // medians of the ratios of neighbouring runs
  bool same_result = false;                             // hand and engine agree to rounding
};

std::vector<TaxCell> tax_cells();

/// Rounds of all implementations in shuffled order, so that drift of the machine hits all alike.
std::vector<TaxResult> measure_tax(const std::vector<TaxCell>& cells, int rounds, long steps);

/// One sentence a cell over its goal (1.10 of the hand loop, 1.03 of odeint), none where all hold.
std::vector<std::string> tax_faults(const std::vector<TaxResult>& results);

std::string tax_table(const std::vector<TaxResult>& results);

}  // namespace odemark
