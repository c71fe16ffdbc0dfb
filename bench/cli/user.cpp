#include "bench/cli/user.hpp"

// alone in its object file, so that the linker takes it only where a program defines none of its own
void odemark_user_register(odemark::Registry&) {}
