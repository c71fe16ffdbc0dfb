// The steppers of GSL's odeiv2 as contestants. GSL is GPL-3: linking this target decides a binary's licence.
#pragma once

#include "reference/contestants.hpp"

namespace odemark::contestant {

void add_gsl(std::vector<AnyMethod>& methods);
ProviderInfo gsl_provider();

}  // namespace odemark::contestant
