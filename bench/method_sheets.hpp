// The sheets of many methods, with what was measured and the picture of the region, as reports want them.
#pragma once

#include <functional>

#include "bench/facts.hpp"

namespace odemark {

/// Methods of guests have no coefficients here and are left out. `progress` is told after every method.
std::vector<FactSheet> method_sheets(
    const std::vector<AnyMethod>& methods,
    const std::function<void(std::size_t done, std::size_t total)>& progress = {});

}  // namespace odemark
