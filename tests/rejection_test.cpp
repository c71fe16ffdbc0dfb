// A rejected attempt leaves no trace: neither in y, nor in the history, nor in any later result.
#include <gtest/gtest.h>

#include "integrators/erased_stepper.hpp"
#include "tests/support/probe_families.hpp"
#include "tests/support/runs.hpp"

namespace odemark::rejection_test {
namespace {

using System = ErasedSystem<double>;
using State = System::State;

/// Ten steps of size h; where `disturbed`, each is preceded by attempts of other sizes that are never
/// accepted.
struct Walk {
  const AnyMethod& method;
  const AnyProblem& problem;
  bool disturbed;
  std::vector<State> seen{};

  void operator()(ErasedStepper<double> stepper) {
    State y = problem.initial, next = y, error(y.size(), 0.0);
    const double h = problem.suggested_dt;
    stepper.start();
    for (int n = 0; n < 10; ++n) {
      const double t = problem.t_begin + n * h;
      if (disturbed)
        for (const double factor : {1e6, 3.0, 0.125}) {
          const State before = y;
          (void)stepper.attempt(t, y, factor * h, next, error);
          EXPECT_TRUE(same_bits(before, y)) << "y was written to";
        }
      const StepStatus status = stepper.attempt(t, y, h, next, error);
      EXPECT_EQ(status, StepStatus::ok);
      stepper.accept();
      y = next;
      seen.push_back(y);
      if (method.needs == 0 && method.embedded_order > 0) seen.push_back(error);
      for (std::size_t k = 0; k < stepper.history_length(); ++k) seen.push_back(stepper.history(k));
    }
  }
};

std::vector<State> walk(const AnyMethod& method, const AnyProblem& problem, bool disturbed) {
  Walk walk{method, problem, disturbed};
  method.runs<double>().with_stepper(
      problem.system<double>(), problem.initial, &walk,
      [](void* self, ErasedStepper<double> stepper) { (*static_cast<Walk*>(self))(stepper); });
  return walk.seen;
}

TEST(Rejection, LeavesNoTrace) {
  const std::vector<AnyProblem> problems{
      probe::problem<probe::Driven>(),   probe::problem<probe::DrivenDamped>(),
      suite_problem("van_der_pol_mu1"),  suite_problem("pendulum"),
      suite_problem("stiff_spring"),     suite_problem("free_rigid_body"),
      probe::problem<probe::DrivenTop>()};
  for (const auto& method : suite_methods()) {
    SCOPED_TRACE(method.id);
    int tried = 0;
    for (const auto& problem : problems) {
      if (!missing_ability(method.needs, problem.abilities).empty()) continue;
      ++tried;
      const auto calm = walk(method, problem, false), disturbed = walk(method, problem, true);
      ASSERT_EQ(calm.size(), disturbed.size());
      for (std::size_t i = 0; i < calm.size(); ++i)
        ASSERT_TRUE(same_bits(calm[i], disturbed[i])) << problem.id << ", record " << i;
    }
    EXPECT_GE(tried, 2);
  }
}

}  // namespace
}  // namespace odemark::rejection_test
