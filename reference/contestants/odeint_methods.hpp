// The steppers of Boost.odeint as contestants, on std::vector<double> and the erased system.
#pragma once

#include "reference/contestants.hpp"

namespace odemark::contestant {

void add_odeint_explicit(std::vector<AnyMethod>& methods);
void add_odeint_bulirsch_stoer(std::vector<AnyMethod>& methods);
void add_odeint_rosenbrock(std::vector<AnyMethod>& methods);
void add_odeint_velocity_verlet(std::vector<AnyMethod>& methods);
void add_odeint_inlined(std::vector<InlinedContestant>& runs);
ProviderInfo odeint_provider();

}  // namespace odemark::contestant
