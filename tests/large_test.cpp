// Problems whose size is a parameter: their bands, their truths, and that nothing grows with the square.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "bench/plan.hpp"
#include "problems/standing_waves.hpp"
#include "reference/bad_input.hpp"
#include "reference/make_family.hpp"
#include "reference/truth_sampled.hpp"
#include "reference/truth_store.hpp"
#include "tests/support/count_allocations.hpp"
#include "tests/support/wide_views.hpp"

namespace odemark::large_test {
namespace {

constexpr std::string_view sized_families[] = {"heat_rod", "spring_chain"};

TEST(Large, SizesAreParameters) {
  EXPECT_EQ(suite_problem("heat_rod").size(), 10u);
  EXPECT_EQ(suite_problem("heat_rod", "n=1").size(), 1u);
  EXPECT_EQ(suite_problem("spring_chain_100000").size(), 200'000u);
  EXPECT_EQ(suite_problem("heat_rod", "n=1e6").size(), 1'000'000u);
  const auto chain = suite_problem("spring_chain", "n=12");
  EXPECT_EQ(chain.components.at(11).name, "x12");
  EXPECT_EQ(chain.components.at(12).name, "v1");
  EXPECT_EQ(chain.components.at(23).unit, "m/s");
  for (const auto family : sized_families)
    for (const char* wrong : {"n=0", "n=2.5", "n=1000001", "n=-3", "n=x"})
      EXPECT_THROW(suite_problem(family, wrong), BadInput) << family << " " << wrong;
}

TEST(Large, LargePresetsAreThoseThatAreNotStored) {
  int large = 0;
  for (const auto& family : suite_families()) {
    EXPECT_FALSE(family.create(family.presets.front(), {}).is_large())
        << family.id << ": tests over the catalogue see the first preset";
    for (const auto& preset : family.presets) {
      const auto problem = family.create(preset, {});
      const auto stored = stored_solutions();
      const bool is_stored = std::any_of(stored.begin(), stored.end(),
                                         [&](const StoredSolution& s) { return s.preset == preset.id; });
      EXPECT_NE(is_stored, problem.is_large()) << preset.id;
      large += problem.is_large();
    }
  }
  EXPECT_EQ(large, 4);
}

TEST(Large, SuitesRunLargeProblemsOnlyWhenAsked) {
  PlanOptions options;
  options.suite = "full", options.methods = "rk4";
  for (const auto& run : make_plan(suite_registry(), options)) EXPECT_FALSE(run.problem->is_large());
  options.problems = "heat_rod_*";
  std::set<std::string> named;
  for (const auto& run : make_plan(suite_registry(), options)) named.insert(run.problem->id);
  EXPECT_EQ(named, (std::set<std::string>{"heat_rod_1000", "heat_rod_100000"}));
}

/// What is wrong with a band, in one sentence: its entries are compared with all of dual numbers' Jacobian,
/// and the numbers around its storage must stay what they were. Empty where nothing is.
std::string band_fault(const ErasedSystem<double>& system, const std::vector<double>& y,
                       const std::vector<double>& dual) {
  const MatrixShape shape = system.jacobian_shape();
  if (shape.is_dense()) return "the Jacobian is not banded";
  const std::size_t n = shape.size, margin = 4 * n;
  constexpr double untouched = 0.8125;
  std::vector<double> storage(margin + n * shape.rows() + margin, untouched);
  std::fill_n(storage.begin() + std::ptrdiff_t(margin), n * shape.rows(), 0.0);
  const double* band = storage.data() + margin;
  system.band_call(system.self, 0, y.data(), storage.data() + margin);
  for (std::size_t i = 0; i < margin; ++i)
    if (storage[i] != untouched || storage[storage.size() - 1 - i] != untouched)
      return "it writes outside of its storage";
  for (std::size_t c = 0; c < n; ++c)
    for (std::size_t r = 0; r < n; ++r) {
      const std::size_t row = shape.place(r), column = shape.place(c);
      const bool inside = row <= column + shape.lower && column <= row + shape.upper;
      const double entry = inside ? band[column * shape.rows() + shape.upper + row - column] : 0;
      if (!(std::abs(entry - dual[c * n + r]) <= 1e-13 * (1 + std::abs(dual[c * n + r]))))
        return fmt::format("entry ({}, {}) is {} instead of {}", r, c, entry, dual[c * n + r]);
    }
  return "";
}

template <class F>
std::string band_fault(const F& family) {
  const auto system = erase<double>(family);
  std::vector<double> y(system.size), dual(system.size * system.size);
  family.initial(y.data());
  dual_jacobian(family, 0.0, y.data(), MatrixView<double>{dual.data(), system.size});
  return band_fault(system, y, dual);
}

TEST(Large, BandsHoldTheWholeJacobian) {
  int banded = 0;
  for (const auto& problem : every_preset()) {
    if (problem.system<double>().band.size == 0) continue;
    ++banded;
    for (const char* settings : {"n=7", "n=10", "n=33"}) {
      const auto sized = suite_problem(problem.id, settings);
      const WideProblem wide = widened(sized, false);
      std::vector<Wide> dual(wide.size * wide.size);
      wide.jacobian(wide.value.get(), Wide(0), wide.initial.data(), dual.data());
      std::vector<double> rounded;
      for (const Wide& entry : dual) rounded.push_back(to_double(entry));
      EXPECT_EQ(band_fault(sized.system<double>(), sized.initial, rounded), "") << sized.id;
    }
  }
  EXPECT_EQ(banded, int(std::size(sized_families)));
}

/// y_i' = -y_i + the sum of the next `feels` neighbours, which says that its band has `says` diagonals to
/// either side and writes `writes` of them.
struct PlantedRow {
  std::size_t feels = 1, says = 1, writes = 1;

  std::size_t size() const { return 10; }
  Bandwidth bandwidth() const { return {says, says}; }
  template <class T>
  void initial(T* y) const {
    for (std::size_t i = 0; i < size(); ++i) y[i] = T(1);
  }
  template <class T>
  void rhs(const T&, const T* y, T* dydt) const {
    for (std::size_t i = 0; i < size(); ++i) {
      dydt[i] = -y[i];
      for (std::size_t d = 1; d <= feels && i + d < size(); ++d) dydt[i] = dydt[i] + y[i + d];
    }
  }
  template <class T, class J>
  void jacobian(const T&, const T*, J&& j) const {
    for (std::size_t i = 0; i < size(); ++i) {
      j(i, i) = T(-1);
      for (std::size_t d = 1; d <= writes && i + d < size(); ++d) j(i, i + d) = T(1);
    }
  }
};

TEST(Large, APlantedEntryOutsideOfItsBandIsFound) {
  EXPECT_EQ(band_fault(PlantedRow{1, 1, 1}), "");
  EXPECT_EQ(band_fault(PlantedRow{2, 2, 2}), "");
  EXPECT_NE(band_fault(PlantedRow{2, 1, 2}), "") << "written outside of the band";
  EXPECT_NE(band_fault(PlantedRow{2, 1, 1}), "") << "felt outside of the band";
  EXPECT_NE(band_fault(PlantedRow{1, 1, 2}), "") << "written where nothing is felt";
  EXPECT_NE(band_fault(PlantedRow{1, 1, 0}), "") << "forgotten";
  EXPECT_NE(band_fault(PlantedRow{4, 4, 5}), "") << "written beyond its storage";
}

/// The closed form of single components is that of the whole state, and its bound covers what rounding the
/// initial state makes of it.
TEST(Large, SampledTruthIsTheWholeTruth) {
  for (const auto family : sized_families)
    for (const char* settings : {"n=10", "n=50", "n=101"}) {
      const auto problem = suite_problem(family, settings);
      SCOPED_TRACE(problem.id);
      const Truth sampled = sampled_truth(problem);
      ASSERT_EQ(sampled.places.size(), problem.size());
      const WideProblem wide = widened(problem, false);
      std::vector<Wide> y(wide.size);
      wide.exact(wide.value.get(), Wide(problem.t_end), wide.initial.data(), y.data());
      double worst = 0;
      for (std::size_t i = 0; i < y.size(); ++i) {
        const auto& value = sampled.last().values[i];
        const double gap = std::abs(to_double(y[i] - Wide(value.decimal)));
        EXPECT_LE(gap, double(value.bound)) << i;
        worst = std::max(worst, gap / double(value.bound));
      }
      EXPECT_GT(worst, 1e-4) << "a bound that is never approached says nothing";
      EXPECT_GE(sampled.digits, 12);
    }
}

TEST(Large, InitialStatesAreRoundedNoWorseThanTheirTruthAssumes) {
  for (const auto family : sized_families) {
    const auto problem = suite_problem(family, "n=100000");
    for (const auto& wide : suite_wide_families()) {
      if (wide.id != family) continue;
      const auto places = compared_components(problem);
      EXPECT_EQ(places.front(), 0u);
      EXPECT_EQ(places.back(), problem.size() - 1);
      EXPECT_TRUE(std::is_sorted(places.begin(), places.end()));
      const auto start = wide.sampled(problem, Wide(0), places);
      for (std::size_t p = 0; p < places.size(); ++p)
        EXPECT_NEAR(to_double(start.y[p] - Wide(problem.initial[places[p]])), 0,
                    4 * std::numeric_limits<double>::epsilon())
            << places[p];
    }
  }
}

TEST(Large, SinesOfManyTurnsKeepTheirDigits) {
  for (const std::size_t i : {1u, 99'999u, 250'001u, 1'000'000u})
    for (const std::size_t mode : {1u, 3u, 125'000u, 333'333u})
      EXPECT_NEAR(
          to_double(mode_sine<Wide>(i, mode, 1'000'000) - Wide(mode_sine<double>(i, mode, 1'000'000))), 0,
          4e-16);
}

RunRequest request_of(std::optional<long> steps, double rtol = 0) {
  RunRequest request;
  if (steps)
    request.steps = steps;
  else
    request.rtol = rtol;
  return request;
}

TEST(Large, MethodsOfEveryKindMeetTheTruth) {
  struct Case {
    const char *problem, *method;
    std::optional<long> steps;
    double rtol, error;
  };
  const Case cases[] = {{"spring_chain_1000", "rk4", 2048, 0, 2e-6},
                        {"spring_chain_1000", "stormer_verlet", 4096, 0, 5e-3},
                        {"spring_chain_1000", "dormand_prince54", {}, 1e-8, 1e-6},
                        {"spring_chain_1000", "radau_iia5", {}, 1e-8, 1e-5},
                        {"spring_chain_1000", "gauss4", 512, 0, 1e-3},
                        {"spring_chain_1000", "newmark_beta", 2048, 0, 2e-2},
                        {"heat_rod_1000", "radau_iia5", {}, 1e-8, 1e-7},
                        {"heat_rod_1000", "rodas5p", {}, 1e-8, 1e-6},
                        {"heat_rod_1000", "bdf", {}, 1e-8, 1e-5},
                        {"heat_rod_1000", "sdirk2", 256, 0, 1e-4},
                        {"heat_rod_1000", "rkc2", 256, 0, 1e-4},
                        {"heat_rod_1000", "rock4", {}, 1e-6, 1e-5}};
  for (const auto& c : cases) {
    const auto problem = suite_problem(c.problem);
    const Row row = run(suite_method(c.method), problem, request_of(c.steps, c.rtol), "large");
    SCOPED_TRACE(row.id + ": " + row.status + " " + row.reason);
    ASSERT_TRUE(row.errors.has_value());
    EXPECT_LT(row.errors->scaled, c.error);
    EXPECT_GT(row.errors->scaled, 0);
    EXPECT_LT(row.truth_floor, c.error);
    EXPECT_FALSE(row.errors->trajectory_max.has_value());
  }
  // and a wrong solution does not: another stiffness
  const auto problem = suite_problem("spring_chain_1000"),
             other = suite_problem("spring_chain_1000", "k=101");
  auto y = solve(suite_method("rk4"), other, FixedSteps{2048}).y;
  const auto truth = truth_of(problem);
  double worst = 0;
  for (std::size_t p = 0; p < truth->places.size(); ++p)
    worst = std::max(worst, double(std::abs(difference(y[truth->places[p]], truth->last().values[p]))) /
                                problem.scale[truth->places[p]]);
  EXPECT_GT(worst, 1e-2);
}

/// Whole matrices of these would take 128 MB, of half a state 32 MB.
TEST(Large, NoMethodAsksForTheSquareOfTheSize) {
  for (const char* id : {"heat_rod", "spring_chain"}) {
    const auto problem =
        suite_problem(id, id == sized_families[0] ? "n=4000,t_end=1e-6" : "n=2000,t_end=1e-3");
    ASSERT_EQ(problem.size(), 4000u);
    int ran = 0;
    for (const auto& method : suite_registry().methods) {
      SCOPED_TRACE(fmt::format("{}/{}", problem.id, method.id));
      if (!can_run<double>(method, problem)) continue;
      ++ran;
      ErrorControl control{1e-4, 1e-4};
      control.scale = problem.scale.data(), control.step_limit = 4;
      largest_request = 0;
      const auto end =
          method.takes_fixed_steps ? solve(method, problem, FixedSteps{2}) : solve(method, problem, control);
      const bool moderate_only = end.report.status == RunStatus::not_applicable;
      EXPECT_TRUE(!moderate_only || method.provider == "sundials") << end.report.reason;
      EXPECT_LT(largest_request, 16u << 20) << "bytes at once";
    }
    EXPECT_GE(ran, 100);
  }
}

TEST(Large, WhatNeedsWholeMatricesSaysSo) {
  const auto chain = suite_problem("spring_chain", "n=1001"), small = suite_problem("spring_chain");
  for (const char* id : {"exponential_euler", "gsl_bsimp", "odeint_rosenbrock4"})
    for (const auto& method : suite_registry().methods) {
      if (method.id != id) continue;
      EXPECT_EQ(missing_ability(method.needs, small.abilities), "") << id;
      const Row row = run(method, chain, request_of(4), "large");
      EXPECT_EQ(row.status, "not_applicable") << id;
    }
}

}  // namespace
}  // namespace odemark::large_test
