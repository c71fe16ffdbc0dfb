// The Jacobian a family has written is the one that dual numbers and differences give.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/probe_families.hpp"
#include "tests/support/wide_views.hpp"

namespace odemark::jacobian_test {
namespace {

TEST(Jacobian, WrittenEqualsDualNumbersEqualsDifferences) {
  for (const auto& problem : every_preset()) {
    SCOPED_TRACE(problem.id);
    const WideProblem wide = widened(problem, false);
    const std::size_t n = problem.size();
    for (const auto& place : places_of(problem, 8)) {
      const Wide t(place.t);
      const void* phase = phase_at(wide, t).value.get();
      const auto y = converted<Wide>(place.y);
      std::vector<Wide> dual(n * n), above(n), below(n);
      wide.jacobian(phase, t, y.data(), dual.data());
      std::vector<double> written(n * n);
      problem.system<double>().jacobian(place.t, place.y, MatrixView<double>{written.data(), n});
      for (std::size_t column = 0; column < n; ++column) {
        auto moved = y;
        const Wide step = Wide(problem.scale[column]) * Wide("1e-20");
        moved[column] = y[column] + step;
        wide.rhs(phase, t, moved.data(), above.data());
        moved[column] = y[column] - step;
        wide.rhs(phase, t, moved.data(), below.data());
        for (std::size_t row = 0; row < n; ++row) {
          const std::size_t at = column * n + row;
          const Wide difference = (above[row] - below[row]) / (2 * step);
          // in units of slope over state, so that a term lost beside a huge one is still missed
          const double size =
              std::max(std::abs(to_double(dual[at])), 1e-6 * problem.scale[row] / problem.scale[column]);
          // the difference knows no more than fifty digits of f leave it: diodes reach 1e20
          const double lost = 4e-50 * std::abs(to_double(above[row])) / to_double(step);
          EXPECT_NEAR(to_double(dual[at] - difference) / std::max(size, 1e12 * lost), 0, 1e-12)
              << "row " << row << ", column " << column;
          EXPECT_NEAR((written[at] - to_double(dual[at])) / size, 0, 1e-13)
              << "row " << row << ", column " << column;
        }
      }
    }
  }
}

TEST(Jacobian, WrittenEqualsDualNumbersInEveryPhaseOfEvents) {
  int phases = 0;
  for (const auto& problem : every_preset()) {
    const WideProblem wide = widened(problem, false);
    if (!wide.events.jumps) continue;
    const std::size_t n = problem.size();
    ASSERT_EQ(problem.pieces<double>().phases.size(), wide.phases.size()) << problem.id;
    for (std::size_t phase = 0; phase < wide.phases.size(); ++phase, ++phases)
      for (const auto& place : places_of(problem, 4)) {
        const auto y = converted<Wide>(place.y);
        std::vector<Wide> dual(n * n);
        wide.jacobian(wide.phases[phase].value.get(), Wide(place.t), y.data(), dual.data());
        std::vector<double> written(n * n);
        problem.pieces<double>().phases[phase].jacobian(place.t, place.y,
                                                        MatrixView<double>{written.data(), n});
        for (std::size_t i = 0; i < n * n; ++i)
          EXPECT_NEAR(written[i], to_double(dual[i]), 1e-13 * (1 + std::abs(written[i])))
              << problem.id << " in phase " << phase;
      }
  }
  EXPECT_GE(phases, 20);
}

TEST(Jacobian, DualNumbersStandInWhereNoneIsWritten) {
  const auto problem = probe::problem<probe::DrivenDamped>();
  EXPECT_FALSE(problem.has_written_jacobian);
  std::vector<double> j(4);
  problem.system<double>().jacobian(0.5, {0.25, 2}, MatrixView<double>{j.data(), 2});
  EXPECT_EQ(j, (std::vector<double>{0, -1, 1, -12}));
}

/// Every function a right-hand side may call, on dual numbers and as a difference.
TEST(Jacobian, DualNumbersKnowTheSlopeOfEveryFunction) {
  using D = Dual<long double, 1>;
  const auto expect_slope = [](const char* name, const auto& f) {
    for (const long double x : {0.3L, 1.1L, 2.7L}) {
      const long double step = 1e-6L, difference = (f(x + step) - f(x - step)) / (2 * step);
      EXPECT_NEAR(double(f(D::variable(x, 0)).partial[0] / difference), 1, 1e-10)
          << name << " at " << double(x);
      EXPECT_EQ(f(D(x)).value, f(x)) << name;
    }
  };
  using std::sqrt, std::exp, std::log, std::sin, std::cos, std::sinh, std::cosh, std::tanh, std::atan,
      std::pow, std::abs;
  expect_slope("sqrt", [](auto x) { return sqrt(x); });
  expect_slope("exp", [](auto x) { return exp(x); });
  expect_slope("log", [](auto x) { return log(x); });
  expect_slope("sin", [](auto x) { return sin(x); });
  expect_slope("cos", [](auto x) { return cos(x); });
  expect_slope("sinh", [](auto x) { return sinh(x); });
  expect_slope("cosh", [](auto x) { return cosh(x); });
  expect_slope("tanh", [](auto x) { return tanh(x); });
  expect_slope("atan", [](auto x) { return atan(x); });
  expect_slope("pow", [](auto x) { return pow(x, decltype(x)(1.75L)); });
  expect_slope("abs", [](auto x) { return abs(1 - x); });
}

TEST(Jacobian, TheSameInEveryNumberType) {
  for (const auto& problem : every_preset()) {
    const std::size_t n = problem.size();
    std::vector<float> narrow(n * n);
    std::vector<double> j(n * n);
    std::vector<long double> wider(n * n);
    const auto place = places_of(problem, 2).back();
    problem.system<float>().jacobian(float(place.t), converted<float>(place.y),
                                     MatrixView<float>{narrow.data(), n});
    problem.system<double>().jacobian(place.t, place.y, MatrixView<double>{j.data(), n});
    problem.system<long double>().jacobian(static_cast<long double>(place.t), converted<long double>(place.y),
                                           MatrixView<long double>{wider.data(), n});
    for (std::size_t i = 0; i < n * n; ++i) {
      EXPECT_NEAR(double(narrow[i]), j[i], 2e-3 * (1e-3 + std::abs(j[i]))) << problem.id;
      EXPECT_NEAR(double(wider[i]), j[i], 1e-12 * (1e-3 + std::abs(j[i]))) << problem.id;
    }
  }
}

}  // namespace
}  // namespace odemark::jacobian_test
