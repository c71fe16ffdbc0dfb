// The one function a program defines to add its own methods and problems to the ready-made main.
#pragma once

#include "bench/registry.hpp"

/// Called once before the command line is read. Link odemark::main and define it; the library's own does
/// nothing.
void odemark_user_register(odemark::Registry& registry);
