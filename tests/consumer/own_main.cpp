// The command line of odemark with an own method and an own problem beside the suite's.
#include "bench/cli/user.hpp"
#include "integrators/erase_method.hpp"
#include "own_method.hpp"
#include "own_problem.hpp"
#include "reference/make_family.hpp"

void odemark_user_register(odemark::Registry& registry) {
  registry.methods.push_back(odemark::erase_method<consumer::my_ralston3>());
  registry.families.push_back(odemark::make_family<consumer::Logistic>());
}
