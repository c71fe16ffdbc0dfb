// The ready-made main(): the suite plus whatever the user's program adds.
#include "bench/cli/commands.hpp"
#include "bench/cli/user.hpp"

int main(int argc, char** argv) {
  odemark::Registry registry = odemark::suite_registry();
  odemark_user_register(registry);
  return odemark::odemark_main(argc, argv, registry);
}
