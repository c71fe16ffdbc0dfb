// The ready-made main(): the suite plus whatever the user's program adds.
#include <cerrno>
#include <cstdio>
#include <cstring>

#include "bench/cli/commands.hpp"
#include "bench/cli/user.hpp"

int main(int argc, char** argv) {
  odemark::Registry registry = odemark::suite_registry();
  odemark_user_register(registry);
  const int code = odemark::odemark_main(argc, argv, registry);
  if (std::fflush(stdout) == 0) return code;
  // what was printed counts only if it arrived
  std::fprintf(stderr, "odemark: cannot write to standard output: %s\n", std::strerror(errno));
  return odemark::exit_failed;
}
