// What can be run: the suite's methods and families, the contestants that were built in, and a user's own.
#pragma once

#include <string_view>
#include <vector>

#include "integrators/any_method.hpp"
#include "reference/any_problem.hpp"

namespace odemark {

struct Registry {
  std::vector<AnyMethod> methods;
  std::vector<AnyFamily> families;
};

/// Everything this binary has.
Registry suite_registry();

/// Throws BadInput with the nearest name.
/// Throws BadInput where two methods or two presets have one id: no row could be told from another.
void require_unique_names(const Registry& registry);

const AnyMethod& find_method(const Registry& registry, std::string_view id);

/// "rk4,heun", or with wildcards "taylor*,sdirk?"; each pattern must match something (BadInput otherwise).
/// Empty text: all.
std::vector<const AnyMethod*> select_methods(const Registry& registry, std::string_view patterns);
/// The same for presets; a family's name stands for its first preset.
std::vector<AnyProblem> select_problems(const Registry& registry, std::string_view patterns,
                                        std::string_view settings = "");

/// * any run of characters, ? any one.
bool matches(std::string_view pattern, std::string_view text);

}  // namespace odemark
