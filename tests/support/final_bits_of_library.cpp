// The lines of final_bits.cpp from the library as it was built and is shipped.
#include "bench/registry.hpp"
#include "tests/support/final_bits.hpp"

namespace {

using namespace odemark;

template <class T>
void print_end(const AnyMethod& method, std::string_view id, const AnyProblem& problem, const char* type,
               const Control& control) {
  if (!missing_ability(method.needs, problem.abilities).empty()) return;
  std::vector<T> y(problem.initial.begin(), problem.initial.end());
  method.runs<T>().solve(problem.system<T>(), control, 0, 2, y);
  print_bits(id, method.id, type, y);
}

void print_all(std::string_view id, const std::vector<Setting>& settings, long steps) {
  const AnyFamily& family = *std::ranges::find(suite_families(), id, &AnyFamily::id);
  const AnyProblem problem = family.create(Preset{}, settings);
  const auto method = [](std::string_view name) -> const AnyMethod& {
    return *std::ranges::find(suite_methods(), name, &AnyMethod::id);
  };
  const auto fixed = {"explicit_euler",
                      "rk4",
                      "dormand_prince54",
                      "tsitouras54",
                      "adams_bashforth3",
                      "semi_implicit_euler",
                      "yoshida4",
                      "implicit_midpoint",
                      "sdirk2",
                      "radau_iia5",
                      "taylor8",
                      "newmark_beta",
                      "rigid_body_splitting"};
  for (const auto* name : fixed) print_end<double>(method(name), id, problem, "double", FixedSteps{steps});
  for (const auto* name : fixed) print_end<float>(method(name), id, problem, "float", FixedSteps{steps});
  for (const auto* name : {"dormand_prince54", "taylor8", "esdirk43", "radau_iia5"})
    print_end<double>(method(name), id, problem, "controlled", ErrorControl{1e-7, 1e-9});
}

}  // namespace

int main() {
  print_all("kepler", {}, 300);
  print_all("free_rigid_body", {}, 300);
  print_all("lorenz63", {}, 300);
  print_all("pendulum", {}, 300);
  print_all("stiff_spring", {{"k", "10000"}, {"c", "50"}}, 2000);
}
