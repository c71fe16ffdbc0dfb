// What should stay constant and did not: invariants, amplitude and phase.
#pragma once

#include <string>
#include <vector>

#include "bench/data/row.hpp"
#include "reports/table.hpp"

namespace odemark {

/// Problems with an invariant that some run watched, in the order of the rows.
std::vector<std::string> conserving_problems(const std::vector<Row>& rows);

/// Of every method the runs near `dt` and at the finest control: the largest change of each invariant. The
/// least drift first.
Table drift_table(const std::vector<Row>& rows, const std::string& problem, double dt);

/// Amplitude and phase after the run, where the problem is an oscillation; no rows elsewhere.
Table oscillation_table(const std::vector<Row>& rows, const std::string& problem, double dt);

/// "At dt = 0.05 s yoshida4 lets the energy drift by 1e-9, explicit_euler by 0.28."
std::string drift_answer(const std::vector<Row>& rows, const std::string& problem, double dt);

}  // namespace odemark
