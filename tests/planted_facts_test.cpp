// Faults planted in one method of each family are found by the facts of its coefficients or of its step, by
// name.
#include <gmock/gmock.h>

#include <limits>

#include "bench/facts.hpp"
#include "bench/measured_facts.hpp"
#include "integrators/facts.hpp"
#include "integrators/methods/blanes_moan_rkn4.hpp"
#include "integrators/methods/bogacki_shampine32.hpp"
#include "integrators/methods/dormand_prince54.hpp"
#include "integrators/methods/heun.hpp"
#include "integrators/methods/mclachlan_atela4.hpp"
#include "integrators/methods/radau_iia5.hpp"
#include "integrators/methods/rk4.hpp"
#include "integrators/methods/rkn_dormand_prince64.hpp"
#include "integrators/methods/sdirk2.hpp"
#include "integrators/methods/sdirk43.hpp"
#include "integrators/methods/yoshida4.hpp"
#include "tests/planted/planted_methods.hpp"

namespace odemark::planted_facts_test {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;

std::vector<std::string> measured_faults_of(const AnyMethod& method) {
  FactSheet sheet = fact_sheet(method);
  sheet.measured = measure_facts(method);
  return measured_faults(sheet);
}

// --- what coefficients tell ---

TEST(PlantedInCoefficients, OneWrongDigitOfAnExplicitMethod) {
  EXPECT_THAT(claim_faults(erase_method<planted::rk4_wrong_coefficient>()),
              Contains(HasSubstr("rk4_wrong_coefficient: order 4 is claimed")));
}

constexpr auto wrong_sign_of_estimate = [] {
  auto m = dormand_prince54;
  m.id = "wrong_sign_of_estimate";
  for (auto& b : m.b_embedded) b = -b;
  return m;
}();
constexpr auto difference_as_estimate = [] {
  auto m = dormand_prince54;
  m.id = "difference_as_estimate";
  for (std::size_t i = 0; i < m.b.size(); ++i) m.b_embedded[i] = m.b[i] - m.b_embedded[i];
  return m;
}();

TEST(PlantedInCoefficients, EstimatesThatAreNone) {
  EXPECT_THAT(
      claim_faults(erase_method<wrong_sign_of_estimate>()),
      Contains(HasSubstr("wrong_sign_of_estimate: embedded order 4 is claimed, its coefficients have 0")));
  EXPECT_THAT(
      claim_faults(erase_method<difference_as_estimate>()),
      Contains(HasSubstr("difference_as_estimate: embedded order 4 is claimed, its coefficients have 0")));
}

constexpr auto wrong_gamma = [] {
  auto m = sdirk2;
  m.id = "wrong_gamma";
  m.a[0][0] += 1e-9L, m.a[1][1] += 1e-9L;
  return m;
}();
constexpr auto wrong_adams = [] {
  auto m = adams_bashforth3;
  m.id = "wrong_adams";
  m.formula.slopes[1] += 1e-6L, m.formula.slopes[2] -= 1e-6L;
  return m;
}();
constexpr auto wrong_yoshida = [] {
  auto m = yoshida4;
  m.id = "wrong_yoshida";
  m.kick[1] += 1e-6L, m.kick[2] -= 1e-6L;
  return m;
}();

TEST(PlantedInCoefficients, SmallErrorsInTheOtherFamilies) {
  EXPECT_THAT(claim_faults(erase_method<wrong_gamma>()),
              Contains(HasSubstr("wrong_gamma: order 2 is claimed")));
  EXPECT_THAT(claim_faults(erase_method<wrong_adams>()),
              Contains(HasSubstr("wrong_adams: order 3 is claimed")));
  EXPECT_THAT(claim_faults(erase_method<wrong_yoshida>()),
              Contains(HasSubstr("wrong_yoshida: order 4 is claimed")));
}

// --- what only the compiled step tells ---

/// A stepper of `wrong` that says it has the coefficients of `right`.
template <const auto& wrong, const auto& right>
AnyMethod pretending() {
  AnyMethod m = erase_method<wrong>();
  m.theory = [] { return right.theory(); };
  return m;
}

TEST(PlantedInSteps, CoefficientsThatAreNotThoseOfTheTheory) {
  EXPECT_THAT((measured_faults_of(pretending<planted::rk4_wrong_coefficient, rk4>())),
              Contains(HasSubstr("rk4_wrong_coefficient: R(z) in double")));
  EXPECT_THAT((measured_faults_of(pretending<wrong_gamma, sdirk2>())),
              Contains(HasSubstr("wrong_gamma: R(z) in double")));
  EXPECT_THAT((measured_faults_of(pretending<wrong_adams, adams_bashforth3>())),
              Contains(HasSubstr("wrong_adams: characteristic polynomial in double")));
  EXPECT_THAT((measured_faults_of(pretending<wrong_yoshida, yoshida4>())),
              Contains(HasSubstr("wrong_yoshida: matrix on springs in double")));
}

TEST(PlantedInSteps, AnEstimateWithoutTheMainFormula) {
  EXPECT_THAT((measured_faults_of(pretending<difference_as_estimate, dormand_prince54>())),
              Contains(HasSubstr("difference_as_estimate: error estimate on y' = lambda y in double")));
}

constexpr auto unfiltered = [] {
  auto m = sdirk43;
  m.id = "unfiltered";
  m.filter_estimate = false;
  return m;
}();

/// The plain estimate and the filtered one differ by a factor 1 - gamma z: which of them a step gives is part
/// of what it says of itself.
TEST(PlantedInSteps, AnEstimateThatIsFilteredOrNotAgainstItsWord) {
  EXPECT_THAT((measured_faults_of(pretending<unfiltered, sdirk43>())),
              Contains(HasSubstr("unfiltered: error estimate on y' = lambda y in double")));
  EXPECT_THAT((measured_faults_of(pretending<sdirk43, unfiltered>())),
              Contains(HasSubstr("sdirk43: error estimate on y' = lambda y in double")));
  AnyMethod other_gamma = erase_method<sdirk43>();
  other_gamma.theory = [] {
    Theory theory = sdirk43.theory();
    theory.estimate_filter = 0.251L;
    return theory;
  };
  EXPECT_THAT(measured_faults_of(other_gamma),
              Contains(HasSubstr("sdirk43: error estimate on y' = lambda y in double")));
  EXPECT_THAT(measured_faults_of(erase_method<sdirk43>()), IsEmpty());
  EXPECT_THAT(measured_faults_of(erase_method<unfiltered>()), IsEmpty());
}

/// Radau's estimate has a slope at the start that is no stage: its weight is the real eigenvalue.
TEST(PlantedInSteps, AnEstimateWithAnotherWeightAtTheStart) {
  EXPECT_THAT(measured_faults_of(erase_method<radau_iia5>()), IsEmpty());
  AnyMethod wrong = erase_method<radau_iia5>();
  wrong.theory = [] {
    Theory theory = radau_iia5.theory();
    theory.tableau.embedded_start *= 1.001L;
    return theory;
  };
  EXPECT_THAT(measured_faults_of(wrong),
              Contains(HasSubstr("radau_iia5: error estimate on y' = lambda y in double")));
  EXPECT_THAT(claim_faults(wrong), Contains(HasSubstr("radau_iia5: embedded order 3 is claimed")));
}

/// One of many points where a step is not a number is not made good by those after it.
TEST(PlantedInSteps, NotANumberAtTheFirstPointOnly) {
  static const AnyMethod right = erase_method<rk4>();
  static int calls = 0;
  AnyMethod m = right;
  m.id = "not_a_number_once";
  std::get<MethodRuns<double>>(m.by_type).transition = [](const ErasedSystem<double>& system, double h) {
    auto step = right.runs<double>().transition(system, h);
    if (calls++ == 0) step.columns[0] = std::numeric_limits<double>::quiet_NaN();
    return step;
  };
  EXPECT_THAT(measured_faults_of(m), Contains(HasSubstr("not_a_number_once: R(z) in double")));
}

constexpr ExplicitMultistep<3, heun> one_order_short{
    .id = "one_order_short",
    .source = "planted",
    .order = 3,
    .formula = adams_bashforth3.formula,
};
static_assert(!multistep_holds(one_order_short));

/// What multistep_holds() does not let compile, seen in the steps: the error of the start stays.
TEST(PlantedInSteps, AStarterOfTooLowOrder) {
  EXPECT_THAT(measured_faults_of(erase_method<one_order_short>()),
              Contains(HasSubstr("one_order_short: quadrature in t in double")));
  EXPECT_THAT(measured_faults_of(erase_method<planted::adams_bashforth_poor_start>()),
              Contains(HasSubstr("adams_bashforth_poor_start: quadrature in t in double")));
  EXPECT_THAT(measured_faults_of(erase_method<planted::adams_bashforth_moulton_poor_start>()),
              Contains(HasSubstr("adams_bashforth_moulton_poor_start: quadrature in t in double")));
  EXPECT_THAT(measured_faults_of(erase_method<planted::bdf_poor_start>()),
              Contains(HasSubstr("bdf_poor_start: quadrature in t in double")));
  EXPECT_THAT(measured_faults_of(erase_method<planted::adams_copied_start>()),
              Contains(HasSubstr("adams_copied_start: quadrature in t in double")));
}

constexpr auto wrong_nystrom = [] {
  auto m = rkn_dormand_prince64;
  m.id = "wrong_nystrom";
  m.a[4][2] = 65568.0L / 281250;
  return m;
}();
constexpr auto swapped_nystrom = [] {
  auto m = rkn_dormand_prince64;
  m.id = "swapped_nystrom";
  std::swap(m.b_velocity_embedded, m.b_position_embedded);
  return m;
}();
/// A splitting of order 4 with quadratic kinetic energy whose last digit is off: what it does to a free
/// oscillation stays within rounding of order 4 for every step that is measured.
constexpr auto wrong_digit = [] {
  auto m = blanes_moan_rkn4;
  m.id = "wrong_digit";
  m.kick[1] += 1e-13L, m.kick[2] -= 1e-13L;
  return m;
}();

TEST(PlantedInCoefficients, OrdersOfPartitionedAndNystromMethodsAreProved) {
  EXPECT_THAT(claim_faults(erase_method<wrong_nystrom>()),
              Contains(HasSubstr("wrong_nystrom: order 6 is claimed")));
  EXPECT_THAT(claim_faults(erase_method<swapped_nystrom>()),
              Contains(HasSubstr("swapped_nystrom: embedded order 4 is claimed")));
  EXPECT_THAT(claim_faults(erase_method<wrong_digit>()),
              Contains(HasSubstr("wrong_digit: order 4 is claimed")));
  const auto order_of = [](const Theory& theory, int order, int embedded) {
    return method_facts(theory, order, embedded).order;
  };
  EXPECT_THAT(order_of(rkn_dormand_prince64.theory(), 6, 4).reason, HasSubstr("proved"));
  EXPECT_THAT(order_of(yoshida4.theory(), 4, 0).reason, HasSubstr("for any two flows"));
  EXPECT_THAT(order_of(mclachlan_atela4.theory(), 4, 0).reason,
              HasSubstr("3 where the kinetic energy is not quadratic"));
}

/// Bogacki's and Shampine's third-order formula with the nodes 1/2 and 3/4 exchanged: right for every
/// autonomous problem.
struct SwappedNodes {
  template <System P, class Real, class Y>
  void operator()(const P& problem, Real t, Y& y, Real h) const {
    Y k1 = y, k2 = y, k3 = y, at = y;
    problem.rhs(t, y, k1);
    for (std::size_t i = 0; i < size_of(y); ++i) at.data()[i] = y.data()[i] + h / 2 * k1.data()[i];
    problem.rhs(t + 3 * h / 4, at, k2);
    for (std::size_t i = 0; i < size_of(y); ++i) at.data()[i] = y.data()[i] + 3 * h / 4 * k2.data()[i];
    problem.rhs(t + h / 2, at, k3);
    for (std::size_t i = 0; i < size_of(y); ++i)
      y.data()[i] += h / 9 * (2 * k1.data()[i] + 3 * k2.data()[i] + 4 * k3.data()[i]);
  }
};
constexpr auto swapped_nodes = wrap_step("swapped_nodes", 3, SwappedNodes{}, "planted");

TEST(PlantedInSteps, SwappedNodes) {
  const auto faults = measured_faults_of(erase_method<swapped_nodes>());
  EXPECT_THAT(faults, Contains(HasSubstr("swapped_nodes: quadrature in t in double")));
  EXPECT_THAT(faults, Contains(HasSubstr("swapped_nodes: quadrature in t in float")));
}

TEST(PlantedInSteps, ALastStageThatIsNotKept) {
  AnyMethod m = erase_method<bogacki_shampine32>();
  m.id = "forgets_last_stage";
  std::get<MethodRuns<double>>(m.by_type).solve = [](const ErasedSystem<double>& system,
                                                     const Control& control, double t0, double t1,
                                                     std::vector<double>& y) {
    const long steps = std::get<FixedSteps>(control).count;
    RunReport report;
    for (long n = 0; n < steps; ++n) {
      const double h = (t1 - t0) / double(steps);
      report =
          solve<bogacki_shampine32>(system, FixedSteps{1}, t0 + double(n) * h, t0 + double(n + 1) * h, y);
    }
    return report;
  };
  EXPECT_THAT(measured_faults_of(m),
              Contains(HasSubstr("forgets_last_stage: evaluations_per_step in double is off by 1")));
}

TEST(PlantedInSteps, AStepThatDoesNotComeBack) {
  AnyMethod m = erase_method<sdirk2>();
  m.id = "no_way_back";
  m.theory = [] {
    Theory midpoint;
    midpoint.tableau = {1, {0.5L}, {1}, {}, {}};
    midpoint.numerator = {1, 0.5L}, midpoint.denominator = {1, -0.5L};
    return midpoint;
  };
  const auto faults = measured_faults_of(m);
  EXPECT_THAT(faults, Contains(HasSubstr("no_way_back: symmetric in double")));
  EXPECT_THAT(faults, Contains(HasSubstr("no_way_back: symplectic in double")));
}

TEST(PlantedInSteps, RightOnesPass) {
  EXPECT_THAT((measured_faults_of(pretending<dormand_prince54, dormand_prince54>())), IsEmpty());
  EXPECT_THAT((measured_faults_of(pretending<yoshida4, yoshida4>())), IsEmpty());
}

}  // namespace
}  // namespace odemark::planted_facts_test
