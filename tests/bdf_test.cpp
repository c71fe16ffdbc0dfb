// The BDF of variable order: how fast its step may grow, what its formulas are, and what a run of it is
// worth.
#include "integrators/methods/bdf.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "integrators/bdf_formulas.hpp"
#include "integrators/eigenvalues.hpp"
#include "integrators/methods/bdf5.hpp"
#include "integrators/methods/ndf.hpp"
#include "tests/support/probe_families.hpp"
#include "tests/support/runs.hpp"

namespace odemark::bdf_test {
namespace {

using Matrix = std::vector<Coefficient>;

Matrix product(std::size_t n, const Matrix& a, const Matrix& b) {
  Matrix out(n * n, 0);
  for (std::size_t c = 0; c < n; ++c)
    for (std::size_t k = 0; k < n; ++k)
      for (std::size_t r = 0; r < n; ++r) out[c * n + r] += a[k * n + r] * b[c * n + k];
  return out;
}

/// Of the roots but the one at 1, which every consistent method has: above 1 errors grow, whatever the
/// problem.
double largest_but_one(std::vector<WideComplex> roots) {
  std::size_t principal = 0;
  for (std::size_t i = 0; i < roots.size(); ++i)
    if (std::abs(roots[i] - 1.0L) < std::abs(roots[principal] - 1.0L)) principal = i;
  EXPECT_NEAR(double(std::abs(roots[principal] - 1.0L)), 0, 1e-6);  // to rounding, times how far from normal
  double largest = 0;
  for (std::size_t i = 0; i < roots.size(); ++i)
    if (i != principal) largest = std::max(largest, double(std::abs(roots[i])));
  return largest;
}

/// y' = 0 on steps that grow by `ratio` for ever, in the variable-coefficient BDF: the derivative at t_{n+1}
/// of the polynomial through the last order + 1 values.
double variable_coefficient_radius(std::size_t order, double ratio) {
  std::vector<Coefficient> t{0};
  Coefficient h = 1;
  for (std::size_t j = 0; j < order; ++j) t.push_back(t.back() - h), h /= Coefficient(ratio);
  std::vector<WideComplex> companion(order + 1);
  for (std::size_t j = 0; j <= order; ++j) {
    Coefficient weight = j == 0 ? 0 : 1;
    for (std::size_t m = 1; m <= order; ++m) {
      if (j == 0) weight += 1 / (t[0] - t[m]);
      if (j > 0 && m != j) weight *= t[0] - t[m];
    }
    for (std::size_t m = 0; j > 0 && m <= order; ++m)
      if (m != j) weight /= t[j] - t[m];
    companion[order - j] = weight;
  }
  return largest_but_one(polynomial_roots(companion));
}

/// y' = 0 in the scheme of `bdf`: `held` equal steps, then one rescaling by `ratio`.
double own_radius(const BdfFormulas& formulas, std::size_t order, double ratio, std::size_t held) {
  const std::size_t n = order + 1;
  Matrix step(n * n, 0), period(n * n, 0);
  const auto weights = BdfFormulas::rescaling<Coefficient>(order, Coefficient(ratio));
  for (std::size_t c = 0; c < n; ++c) {
    std::vector<Coefficient> d(n + 1, 0);
    d[c] = 1;
    Coefficient known = 0;
    for (std::size_t j = 1; j <= order; ++j) known += BdfFormulas::gamma(j) * d[j];
    d[n] = -known / formulas.leading(order);
    for (std::size_t i = n; i-- > 0;) d[i] += d[i + 1];
    for (std::size_t i = 0; i < n; ++i) step[c * n + i] = d[i], period[c * n + i] = weights[c][i];
  }
  for (std::size_t i = 0; i < held; ++i) period = product(n, period, step);
  return largest_but_one(eigenvalues(n, period));
}

/// The first ratio above 1 where the radius passes 1: scanned, then bisected in the first bad cell.
template <class F>
double ratio_limit(const F& radius) {
  for (double x = 1.0005; x < 50; x += 0.002)
    if (!(radius(x) <= 1)) {
      double low = x - 0.002, high = x;
      for (int i = 0; i < 50; ++i) {
        const double middle = (low + high) / 2;
        (radius(middle) <= 1 ? low : high) = middle;
      }
      return low;
    }
  return std::numeric_limits<double>::infinity();
}

TEST(StepRatios, LimitsOfVariableCoefficientBdf) {
  // 1 + sqrt(2) and (1 + sqrt(5)) / 2 (R. D. Grigorieff, Numer. Math. 42 (1983) 359-377)
  const double published[] = {1 + std::sqrt(2.0), (1 + std::sqrt(5.0)) / 2, 1.2807, 1.1271};
  for (std::size_t order = 2; order <= 5; ++order)
    EXPECT_NEAR(ratio_limit([&](double r) { return variable_coefficient_radius(order, r); }),
                published[order - 2], order < 4 ? 1e-9 : 5e-5)
        << order;
}

TEST(StepRatios, CapsLieBelowTheLimitsOfTheSchemeAndNotFarBelow) {
  for (const BdfFormulas& formulas : {BdfFormulas{bdf.kappa}, BdfFormulas{ndf.kappa}})
    for (std::size_t order = 1; order <= BdfFormulas::highest_order; ++order) {
      const double cap = BdfFormulas::step_ratio_cap[order];
      double least = std::numeric_limits<double>::infinity();
      // the step may be held longer than it must
      for (std::size_t held = order + 1; held <= 4 * order; ++held)
        least = std::min(least, ratio_limit([&](double r) { return own_radius(formulas, order, r, held); }));
      EXPECT_LT(cap, least) << order;
      if (order >= 3) {
        EXPECT_GT(cap, 0.6 * least) << order;
      }
      for (double r = 1; r <= cap; r += 0.01)
        EXPECT_LE(own_radius(formulas, order, r, order + 1), 1) << order << " at " << r;
    }
  // what a cap of 10, which other codes have, would allow
  EXPECT_GT(own_radius(BdfFormulas{bdf.kappa}, 5, 10, 6), 100);
}

TEST(Formulas, EqualStepsOfTheDifferenceFormAreTheFixedStepBdf) {
  // gamma_j differences of y_{n+1} sum to h f: expand in y_{n+1}, y_n, ... and compare with bdf5.hpp
  std::array<Coefficient, 6> weights{};
  for (std::size_t j = 1; j <= 5; ++j) {
    Coefficient binomial = 1;
    for (std::size_t i = 0; i <= j; ++i) {
      weights[i] += (i % 2 == 0 ? 1 : -1) * binomial / Coefficient(j);
      binomial *= Coefficient(j - i) / Coefficient(i + 1);
    }
  }
  for (std::size_t j = 0; j < 5; ++j)
    EXPECT_NEAR(double(-weights[j + 1] / weights[0]), double(bdf5.formula.states[j]), 1e-17);
  EXPECT_NEAR(double(1 / weights[0]), double(bdf5.formula.next_slope), 1e-18);
  EXPECT_NEAR(double(BdfFormulas::gamma(5)), double(weights[0]), 1e-18);
}

TEST(Formulas, RescaledDifferencesAreThoseOfTheSamePolynomial) {
  for (std::size_t order = 1; order <= 5; ++order)
    for (const double ratio : {0.25, 0.9, 1.0, 1.7, 3.0}) {
      const auto value = [&](double t) { return std::pow(t - 2, double(order)) + t; };
      const auto differences = [&](double h) {
        std::vector<double> d;
        for (std::size_t j = 0; j <= order; ++j) {
          double sum = 0, binomial = 1;
          for (std::size_t i = 0; i <= j; ++i) {
            sum += (i % 2 == 0 ? 1 : -1) * binomial * value(-h * double(i));
            binomial *= double(j - i) / double(i + 1);
          }
          d.push_back(sum);
        }
        return d;
      };
      const auto before = differences(0.5), after = differences(0.5 * ratio);
      const auto weights = BdfFormulas::rescaling(order, ratio);
      for (std::size_t j = 0; j <= order; ++j) {
        double sum = 0;
        for (std::size_t m = 0; m <= order; ++m) sum += weights[m][j] * before[m];
        EXPECT_NEAR(sum, after[j], 1e-11 * (1 + std::abs(after[j]))) << order << " x " << ratio;
      }
    }
}

/// Few steps where nothing happens, though the problem is stiff: what an explicit code could not do.
TEST(Runs, StiffDecayTakesFewSteps) {
  for (const char* id : {"bdf", "ndf", "linearly_implicit_euler_extrapolation"}) {
    const auto problem = suite_problem("robertson");
    ErrorControl control{1e-6, 1e-6};
    control.scale = problem.scale.data();
    const auto end = solve(suite_method(id), problem, control);
    EXPECT_EQ(end.report.status, RunStatus::reached_end) << id;
    EXPECT_LT(end.report.accepted, 600) << id;
    EXPECT_LT(end.report.rejected, end.report.accepted / 4) << id;
    EXPECT_GT(end.report.newton.lu, 0) << id;
    EXPECT_LT(end.report.newton.lu, end.report.newton.newton) << id;
  }
}

/// A force that jumps makes the step shrink by orders of magnitude and grow again: growth above the cap would
/// show as steps rejected over and over.
TEST(Runs, TheStepRecoversFromASuddenRefinement) {
  for (const char* id : {"bdf", "ndf"}) {
    const auto problem = suite_problem("van_der_pol_mu100");
    ErrorControl control{1e-6, 1e-6};
    control.scale = problem.scale.data();
    const auto end = solve(suite_method(id), problem, control);
    EXPECT_EQ(end.report.status, RunStatus::reached_end) << id;
    EXPECT_LT(end.report.rejected, end.report.accepted / 3) << id;
    EXPECT_LT(end.report.accepted, 2000) << id;
  }
}

}  // namespace
}  // namespace odemark::bdf_test
