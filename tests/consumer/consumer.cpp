// An own method on the suite's problems, the suite's methods on an own problem, and both own together.
#include <cstdio>

#include "integrators/erase_method.hpp"
#include "own_method.hpp"
#include "own_problem.hpp"
#include "reference/make_family.hpp"

namespace {

constexpr long steps = 64;

/// The end of a run in equal steps; empty where the method does not apply or did not get there.
std::vector<double> end_of(const odemark::AnyMethod& method, const odemark::AnyProblem& problem, long count) {
  std::vector<double> y = problem.initial;
  const auto& runs = method.runs<double>();
  if (!runs.solve || !method.takes_fixed_steps) return {};
  if (!odemark::missing_ability(method.needs, problem.abilities).empty()) return {};
  const auto report =
      runs.solve(problem.system<double>(), odemark::FixedSteps{count}, problem.t_begin, problem.t_end, y);
  return report.status == odemark::RunStatus::reached_end ? y : std::vector<double>{};
}

/// Order seen between two numbers of steps, against `exact` in the first component.
double observed_order(const odemark::AnyMethod& method, const odemark::AnyProblem& problem, double exact) {
  const auto coarse = end_of(method, problem, steps), fine = end_of(method, problem, 2 * steps);
  if (coarse.empty() || fine.empty()) return -1;
  return std::log2(std::abs(coarse[0] - exact) / std::abs(fine[0] - exact));
}

}  // namespace

int main() {
  const auto own_method = odemark::erase_method<consumer::my_ralston3>();
  const auto own_problem =
      odemark::find_problem({odemark::make_family<consumer::Logistic>()}, "my_logistic", "r=2");
  const auto oscillator = odemark::find_problem(odemark::suite_families(), "oscillator");
  const double oscillator_end = std::cos(oscillator.t_end);
  double start = 0.125, own_end = 0;
  consumer::Logistic<>{.r = 2}.exact(own_problem.t_end, &start, &own_end);

  int suite_methods_run = 0;
  for (const auto& method : odemark::suite_methods())
    if (const auto y = end_of(method, own_problem, steps); !y.empty()) {
      ++suite_methods_run;
      std::printf("%-32s error %.1e on own problem\n", std::string(method.id).c_str(),
                  std::abs(y[0] - own_end));
    }
  const double on_own = observed_order(own_method, own_problem, own_end);
  const double on_suite = observed_order(own_method, oscillator, oscillator_end);
  std::printf("%d suite methods; own method: order %.2f on own problem, %.2f on the suite's\n",
              suite_methods_run, on_own, on_suite);
  const bool good = suite_methods_run > 10 && std::abs(on_own - 3) < 0.3 && std::abs(on_suite - 3) < 0.3;
  if (!good) std::printf("expected more than 10 suite methods and order 3 twice\n");
  return good ? 0 : 1;
}
