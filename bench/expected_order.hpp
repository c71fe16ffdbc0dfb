// The order to expect of a method on one problem: its claim, or what theory leaves of it there.
#pragma once

#include <string_view>

#include "integrators/any_method.hpp"
#include "reference/any_problem.hpp"

namespace odemark {

/// Order 0: none is to be expected. The reason is empty where the claim stands.
struct ExpectedOrder {
  int order = 0;
  std::string_view reason = "";
};

ExpectedOrder expected_order(const AnyMethod& method, const AnyProblem& problem);

}  // namespace odemark
