// The solvers of SUNDIALS as contestants.
#pragma once

#include "reference/contestants.hpp"

namespace odemark::contestant {

void add_cvode(std::vector<AnyMethod>& methods);
void add_arkode(std::vector<AnyMethod>& methods);
ProviderInfo sundials_provider();

}  // namespace odemark::contestant
