// Where step sizes come to rest that stability holds down.
#pragma once

#include <string>
#include <vector>

#include "bench/data/settling.hpp"
#include "reports/table.hpp"

namespace odemark {

/// At rest: scatter below a thousandth and no rejection in a hundred steps.
bool settles(const Settling& settling);

/// "Of 40 explicit methods whose step stability holds down, so many come to rest there: 12 under elementary,
/// 39 under pi."
std::string settling_answer(const std::vector<Settling>& all);

/// Methods down; per filter the mean of h |lambda| over the limit, the scatter, the share of rejected steps.
Table settling_table(const std::vector<Settling>& all);

}  // namespace odemark
