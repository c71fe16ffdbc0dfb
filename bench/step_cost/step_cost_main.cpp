// odemark_bench: the benchmark binary.
#include <fmt/format.h>

#include <exception>

#include "bench/step_cost/step_cost.hpp"

int main(int argc, char** argv) {
  try {
    return odemark::step_cost_main({argv + 1, argv + argc}, odemark::suite_registry());
  } catch (const std::exception& e) {
    fmt::print(stderr, "odemark_bench: {}\n", e.what());
    return 4;
  }
}
