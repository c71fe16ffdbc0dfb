// Every method of the suite does what its coefficients say, in double and in float.
#include "bench/measured_facts.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <complex>

#include "bench/facts.hpp"
#include "bench/linear_block.hpp"
#include "integrators/erase_method.hpp"
#include "integrators/methods/hht_alpha_005.hpp"
#include "tests/support/runs.hpp"

namespace odemark::measured_facts_test {
namespace {

using testing::Contains;
using testing::HasSubstr;

class Measured : public testing::TestWithParam<const AnyMethod*> {};

TEST_P(Measured, AgreesWithItsCoefficients) {
  FactSheet sheet = fact_sheet(*GetParam());
  sheet.measured = measure_facts(*GetParam());
  for (const auto& fault : measured_faults(sheet)) ADD_FAILURE() << fault;
}

TEST_P(Measured, AndTheyHaveTheOrdersItClaims) {
  for (const auto& fault : claim_faults(*GetParam())) ADD_FAILURE() << fault;
}

std::vector<const AnyMethod*> all_methods() {
  std::vector<const AnyMethod*> out;
  for (const auto& method : suite_methods()) out.push_back(&method);
  return out;
}

INSTANTIATE_TEST_SUITE_P(Suite, Measured, testing::ValuesIn(all_methods()),
                         [](const auto& test) { return std::string(test.param->id); });

TEST(MeasuredFacts, SomethingIsMeasuredOfEveryMethodThatStepsOnItsOwn) {
  for (const auto& method : suite_methods()) {
    const Theory theory = method.theory();
    if (!method.runs<double>().transition || !theory.blank_reason.empty()) continue;
    int compared = 0;
    for (const auto& fact : measure_facts(method)) compared += fact.difference.has_value();
    EXPECT_GE(compared, 2) << method.id;
  }
}

TEST(MeasuredFacts, WhatIsMeasuredOfAPair) {
  for (const auto& method : suite_methods()) {
    if (method.id != "dormand_prince54") continue;
    std::vector<std::string> names;
    for (const auto& fact : measure_facts(method)) names.push_back(fact.fact + " " + fact.scalar);
    EXPECT_EQ(names, (std::vector<std::string>{"R(z) double", "error estimate on y' = lambda y double",
                                               "evaluations_per_step double", "quadrature in t double",
                                               "R(z) float", "error estimate on y' = lambda y float",
                                               "evaluations_per_step float", "quadrature in t float",
                                               "real_interval double", "oscillator_limit double"}));
  }
}

/// Without the damping of its beta and gamma the blend of forces is of order 1.
constexpr auto undamped_blend = [] {
  auto m = hht_alpha_005;
  m.id = "undamped_blend";
  m.gamma = 0.5L;
  return m;
}();
static_assert(!undamped_blend.second_order_and_stable());

/// A carried acceleration excuses what its start leaves behind, which falls as h^2, and no error that falls
/// as h.
TEST(MeasuredFacts, ACarriedAccelerationIsNoExcuseForAnOrderLess) {
  const AnyMethod method = erase_method<undamped_blend>();
  FactSheet sheet = fact_sheet(method);
  sheet.measured = measure_facts(method);
  const auto faults = measured_faults(sheet);
  EXPECT_THAT(faults, Contains(HasSubstr("undamped_blend: quadrature in t in double")));
  EXPECT_THAT(faults, Contains(HasSubstr("undamped_blend: quadrature in t in float")));
}

/// Does the estimate of a step of y' = lambda y vanish, though the step is off? Then no step of a linear
/// problem with constant coefficients is ever rejected.
bool is_deceived_by_linear_problems(const AnyMethod& method) {
  const std::complex<double> z{-0.5, 0.5};
  const LinearBlock<double> block{z.real(), z.imag()};
  const auto step = method.runs<double>().transition(block.view(), 1);
  const double off = std::abs(std::complex<double>(step.columns[0], step.columns[1]) - std::exp(z));
  return off > 1e-12 && std::hypot(step.errors[0], step.errors[1]) < 1e-4 * off;
}

/// What its advice must say.
TEST(MeasuredFacts, WhoseEstimateIsBlindToLinearProblemsSaysSo) {
  int asked = 0;
  for (const auto& method : suite_methods()) {
    if (!method.takes_error_control || !method.runs<double>().transition || method.multistep) continue;
    if ((method.needs & ~LinearBlock<double>{0, 0}.view().abilities) != 0) continue;
    ++asked;
    EXPECT_EQ(is_deceived_by_linear_problems(method),
              method.advice.find("its estimate is 0 where f is linear") != method.advice.npos)
        << method.id;
  }
  EXPECT_GE(asked, 40);
  EXPECT_TRUE(is_deceived_by_linear_problems(suite_method("ros3p")));
}

TEST(FactSheets, HaveEveryKeyOrAReason) {
  for (const auto& method : suite_methods()) {
    const FactSheet sheet = fact_sheet(method);
    std::vector<std::string> keys;
    for (const auto& line : sheet.facts) {
      keys.push_back(line.key);
      if (std::holds_alternative<std::monostate>(line.value)) {
        EXPECT_FALSE(line.note.empty() || line.note == "not known") << method.id << ": " << line.key;
      }
    }
    for (const char* key : {"stages",
                            "order",
                            "embedded_order",
                            "stage_order",
                            "fsal",
                            "evaluations_per_step",
                            "linear_solves_per_step",
                            "error_constant",
                            "real_interval",
                            "real_islands",
                            "imaginary_interval",
                            "imaginary_interval_eps_1e-3",
                            "imaginary_bands",
                            "log_amplification",
                            "phase_error",
                            "r_infinity",
                            "a_stable",
                            "a_alpha_degrees",
                            "l_stable",
                            "stiffly_accurate",
                            "algebraically_stable",
                            "symplectic",
                            "symmetric",
                            "ssp_coefficient",
                            "oscillator_limit",
                            "oscillator_windows",
                            "damped_limit",
                            "controller_spectral_radius",
                            "internal_amplification",
                            "zero_stable",
                            "step_ratio_limit"})
      EXPECT_EQ(std::count(keys.begin(), keys.end(), key), 1) << method.id << ": " << key;
  }
}

}  // namespace
}  // namespace odemark::measured_facts_test
