// Results as tables for spreadsheets and scripts: every field, full digits, one line per run.
#pragma once

#include <vector>

#include "bench/data/row.hpp"
#include "bench/data/stability.hpp"
#include "reports/table.hpp"

namespace odemark {

/// One column per invariant that occurs; an absent value is an empty field.
Table rows_table(const std::vector<Row>& rows);
Table stability_table(const std::vector<StabilityRow>& rows);

}  // namespace odemark
