// End values printed by others, third witnesses of stored solutions: a wrong constant in a right-hand side or
// an initial value would show here.
#include <gtest/gtest.h>

#include <cmath>

#include "reference/truth.hpp"
#include "reference/truth_store.hpp"
#include "tests/support/runs.hpp"

namespace odemark {
namespace {

void expect_published(const char* preset, const std::vector<double>& printed, double relative) {
  const AnyProblem problem = find_problem(suite_families(), preset);
  const auto truth = truth_of(problem);
  const auto& end = truth->last();
  ASSERT_EQ(end.values.size(), printed.size()) << preset;
  for (std::size_t i = 0; i < printed.size(); ++i)
    EXPECT_NEAR(double(end.values[i].hi) / printed[i], 1, relative)
        << preset << " " << problem.components[i].name;
}

/// F. Mazzia, C. Magherini, Test Set for Initial Value Problem Solvers, release 2.4 (2008), problem plei.
TEST(Published, PleiadesOfTheBariTestSet) {
  expect_published(
      "pleiades",
      {0.3706139143970502,  3.237284092057233,   -3.222559032418324,  0.6597091455775310, 0.3425581707156584,
       1.562172101400631,   -0.7003092922212495, -3.943437585517392,  -3.271380973972550, 5.225081843456543,
       -2.590612434977470,  1.198213693392275,   -0.2429682344935824, 1.091449240428980,  3.417003806314313,
       1.354584501625501,   -2.590065597810775,  2.025053734714242,   -1.155815100160448, -0.8072988170223021,
       0.5952396354208710,  -3.741244961234010,  0.3773459685750630,  0.9386858869551073, 0.3667922227200571,
       -0.3474046353808490, 2.344915448180937,   -1.947020434263292},
      2e-12);
}

/// The same, problem hires.
TEST(Published, HiresOfTheBariTestSet) {
  expect_published(
      "hires",
      {0.7371312573325668e-3, 0.1442485726316185e-3, 0.5888729740967575e-4, 0.1175651343283149e-2,
       0.2386356198831331e-2, 0.6238968252742796e-2, 0.2849998395185769e-2, 0.2850001604814231e-2},
      2e-12);
}

/// The same, problem rober.
TEST(Published, RobertsonOfTheBariTestSet) {
  expect_published("robertson_long", {2.083340149701255e-8, 8.333360770334713e-14, 0.9999999791665050},
                   2e-12);
}

/// W. H. Enright, J. D. Pryce, ACM Algorithm 648 (1987), class F at t = 20. The second component of F1 is
/// exactly 0: the pushes come at its zeros. Copies of F4 differ: without the power 16 of the needle's
/// denominator (two ports) or with 2/21 = 0 in whole numbers (one of them) y(10) is not 1/21.
TEST(Published, ClassFOfDetest) {
  expect_published("detest_f2", {70.03731057008607}, 1e-14);
  expect_published("detest_f3", {-3.726957553088175e-1, -6.230137949234190e-1}, 1e-12);
  expect_published("detest_f4", {9.815017249707434e-11}, 1e-13);
  expect_published("detest_f5", {1.0}, 1e-14);
  const auto first = truth_of(find_problem(suite_families(), "detest_f1"));
  EXPECT_NEAR(double(first->last().values[0].hi), -12.94460621213470, 1e-13);
  EXPECT_NEAR(double(first->last().values[1].hi), 0, 1e-13);
}

}  // namespace
}  // namespace odemark
