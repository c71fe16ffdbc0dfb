// Growth per step: squared matrices against formulas and against stepping; every stepper against its R(z).
#include "bench/stability_growth.hpp"

#include <algorithm>
#include <complex>
#include <limits>
#include <numbers>

#include "bench/stability_region.hpp"
#include "integrators/erase_method.hpp"
#include "integrators/linear_stability_parts.hpp"
#include "integrators/methods/adams_bashforth2.hpp"
#include "integrators/methods/adams_bashforth3.hpp"
#include "integrators/methods/adams_bashforth_moulton34.hpp"
#include "integrators/methods/bdf4.hpp"
#include "integrators/methods/dormand_prince54.hpp"
#include "integrators/methods/explicit_euler.hpp"
#include "integrators/methods/heun.hpp"
#include "integrators/methods/implicit_euler.hpp"
#include "integrators/methods/leapfrog.hpp"
#include "integrators/methods/rk4.hpp"
#include "integrators/methods/stormer_verlet.hpp"
#include "integrators/methods/yoshida4.hpp"
#include "tests/stability_cases.hpp"

namespace odemark::stability_growth_test {
namespace {

// --- growth ---

TEST(StabilityGrowth, SquaringHasNoThreshold) {
  EXPECT_NEAR(double(matrix_growth(2, {1, 0, 1e6L, 1})), 0,
              1e-15);  // a Jordan block grows, but not exponentially
  EXPECT_NEAR(double(matrix_growth(2, {1 + 1e-10L, 0, 0, 0.5L})), 1e-10, 1e-18);
  EXPECT_EQ(double(matrix_growth(2, {0, 0, 1, 0})), -std::numeric_limits<double>::infinity());
  EXPECT_NEAR(double(matrix_growth(2, {0, -1e4L, 1e-4L, 0})), 0, 1e-15);
}

TEST(StabilityGrowth, FormulasOfTheUndampedOscillator) {
  const auto p = spring(0);
  for (const Coefficient z : {0.001L, 0.05L, 0.5236L, 1.0L}) {
    EXPECT_NEAR(double(growth_per_step(explicit_euler.theory(), p, z) / (std::log1p(z * z) / 2)), 1, 1e-14);
    EXPECT_NEAR(double(growth_per_step(heun.theory(), p, z) / (std::log1p(z * z * z * z / 4) / 2)), 1, 1e-12);
    EXPECT_NEAR(double(growth_per_step(implicit_euler.theory(), p, z) / (-std::log1p(z * z) / 2)), 1, 1e-14);
    EXPECT_EQ(double(growth_per_step(stormer_verlet.theory(), p, z)), 0);
  }
}

/// ln of the growth per step of the stepper itself, started as it ships: largest norms of two windows far
/// apart.
template <const auto& stepped>
double growth_by_stepping(const AnyProblem& p, double h, int steps = 6000) {
  using System = ErasedSystem<double>;
  const System& system = p.homogeneous->system<double>();
  std::vector<double> y(p.initial), next(y), error(y);
  StepperOf<stepped, System> stepper(system, y);
  stepper.start();
  constexpr int window = 400;
  double log_scale = 0, largest[2] = {-1e300, -1e300};
  const int first = steps / 3;
  for (int n = 0; n < steps; ++n) {
    EXPECT_EQ(stepper.attempt(n * h, y, h, next, error), StepStatus::ok);
    stepper.accept();
    std::swap(y, next);
    double norm = 0;
    for (const double value : y) norm = std::max(norm, std::abs(value));
    log_scale += std::log(norm);
    for (double& value : y) value /= norm;
    if constexpr (HasHistory<StepperOf<stepped, System>>) {
      for (std::size_t k = 0; k < stepper.history_length(); ++k)
        for (double& value : stepper.history(k)) value /= norm;
    } else {
      stepper.start();  // a slope kept from before the scaling is no slope of y
    }
    const int in = n >= first && n < first + window ? 0 : n >= steps - window ? 1 : -1;
    if (in >= 0) largest[in] = std::max(largest[in], log_scale);
  }
  return (largest[1] - largest[0]) / (steps - window - first);
}

TEST(StabilityGrowth, SteppingAgreesWithTheMatrix) {
  const auto compare = [](const AnyMethod& m, const AnyProblem& p, double h, double stepped) {
    const StepProbe probe(m, p.homogeneous->system<double>());
    const auto growth = double(probe(h).growth);
    EXPECT_NEAR(stepped, growth, 2e-3 * std::abs(growth) + 2e-6) << m.id << " on " << p.id << " at " << h;
  };
  const auto oscillator = problem("oscillator"), spring2 = damped(0.1);
  for (const double h : {0.2, 0.6, 1.2}) {
    compare(method("heun"), oscillator, h, growth_by_stepping<heun>(oscillator, h));
    compare(method("adams_bashforth2"), oscillator, h, growth_by_stepping<adams_bashforth2>(oscillator, h));
    compare(method("adams_bashforth3"), spring2, h, growth_by_stepping<adams_bashforth3>(spring2, h));
    compare(method("rk4"), spring2, 2 * h, growth_by_stepping<rk4>(spring2, 2 * h));
    compare(method("adams_bashforth_moulton34"), spring2, h,
            growth_by_stepping<adams_bashforth_moulton34>(spring2, h));
    compare(method("bdf4"), oscillator, h, growth_by_stepping<bdf4>(oscillator, h));
    compare(method("dormand_prince54"), oscillator, h, growth_by_stepping<dormand_prince54>(oscillator, h));
    compare(method("stormer_verlet"), spring2, 2 * h, growth_by_stepping<stormer_verlet>(spring2, 2 * h));
    compare(method("yoshida4"), oscillator, 2 * h, growth_by_stepping<yoshida4>(oscillator, 2 * h));
    compare(method("implicit_euler"), oscillator, h, growth_by_stepping<implicit_euler>(oscillator, h));
  }
}

/// |b|' (1 + |z| |A| + |z|^2 |A|^2 + ...) 1: what rounding errors inside a step are relative to, where
/// coefficients are large and cancel. 0 without a tableau.
Coefficient rounding_scale(const Tableau& tableau, Coefficient z) {
  const std::size_t s = tableau.stages;
  if (s == 0 || !tableau.gamma.empty()) return 0;
  std::vector<Coefficient> slope(s, 0);
  Coefficient sum = 0;
  for (std::size_t i = 0; i < s; ++i) {
    slope[i] = 1;
    for (std::size_t j = 0; j < i; ++j) slope[i] += z * std::abs(tableau.a[i * s + j]) * slope[j];
    sum += z * std::abs(tableau.b[i]) * slope[i];
  }
  return sum;
}

/// One step of y' = (cos + i sin) y is R(z), |z| = dt, to the rounding of the step itself.
template <class T>
void expect_identity(const AnyMethod& m) {
  const Theory theory = m.theory();
  if (theory.numerator.empty() || !m.runs<T>().transition) return;
  const auto real = stability_limit(theory, real_axis());
  const double reach = real.verdict == Stability::limit ? 1.2 * double(real.limit) : 4;
  for (int i = 0; i < 16; ++i) {
    const double angle = (i + 0.5) * std::numbers::pi / 8;
    const auto p = problem("dahlquist", "lambda_re=" + std::to_string(std::cos(angle)) +
                                            ",lambda_im=" + std::to_string(std::sin(angle)));
    const auto& system = p.homogeneous->system<T>();
    std::vector<T> jacobian(4), zero(2, T(0));
    system.jacobian(T(0), zero, MatrixView<T>{jacobian.data(), 2});
    for (const double part : {0.03, 0.3, 0.7, 1.0}) {
      const T h = T(part * reach);
      const auto step = m.runs<T>().transition(system, h);
      ASSERT_TRUE(step.solved) << m.id;
      const WideComplex z = WideComplex(jacobian[0], jacobian[1]) * Coefficient(h);
      WideComplex numerator = 0, denominator = 0;
      Coefficient size_p = 0, size_q = 0;
      for (std::size_t k = theory.numerator.size(); k-- > 0;) {
        numerator = numerator * z + theory.numerator[k];
        size_p = size_p * std::abs(z) + std::abs(theory.numerator[k]);
      }
      for (std::size_t k = theory.denominator.size(); k-- > 0;) {
        denominator = denominator * z + theory.denominator[k];
        size_q = size_q * std::abs(z) + std::abs(theory.denominator[k]);
      }
      if (std::abs(denominator) < 0.1L) continue;  // near a pole everything is ill-conditioned
      const WideComplex r = numerator / denominator;
      const Coefficient allowed =
          std::numeric_limits<T>::epsilon() *
          (40 * theory.rounding_amplification * (size_p + std::abs(r) * size_q) / std::abs(denominator) +
           (theory.denominator.size() == 1 ? 4 * rounding_scale(theory.tableau, std::abs(z)) : 0));
      EXPECT_LE(double(std::abs(WideComplex(step.columns[0], step.columns[1]) - r)), double(allowed))
          << m.id << " at " << double(z.real()) << " + " << double(z.imag()) << " i";
    }
  }
}

TEST(StabilityIdentity, OneStepOfEverySteppersIsItsStabilityFunction) {
  int compared = 0;
  for (const auto& m : suite_methods()) {
    expect_identity<double>(m), expect_identity<float>(m);
    compared += !m.theory().numerator.empty();
  }
  EXPECT_GT(compared, 30);
}

/// The same for multistep methods: the powers of one step as a matrix have the traces that the roots of the
/// characteristic polynomial give them, to the rounding of their terms.
template <class T>
void expect_multistep_identity(const AnyMethod& m) {
  const Theory theory = m.theory();
  const auto real = stability_limit(theory, real_axis());
  const double reach = real.verdict == Stability::limit ? 1.2 * double(real.limit) : 2;
  for (int i = 0; i < 12; ++i) {
    const double angle = (i + 0.5) * std::numbers::pi / 6;
    const auto p = problem("dahlquist", "lambda_re=" + std::to_string(std::cos(angle)) +
                                            ",lambda_im=" + std::to_string(std::sin(angle)));
    const auto& system = p.homogeneous->system<T>();
    std::vector<T> jacobian(4), zero(2, T(0));
    system.jacobian(T(0), zero, MatrixView<T>{jacobian.data(), 2});
    for (const double part : {0.03, 0.3, 0.7, 1.0}) {
      const T h = T(part * reach);
      const auto step = m.runs<T>().transition(system, h);
      ASSERT_TRUE(step.solved) << m.id;
      const WideComplex z = WideComplex(jacobian[0], jacobian[1]) * Coefficient(h);
      const auto c = detail::characteristic_at(theory, z);
      if (std::abs(c.back()) < 0.2L) continue;  // near a pole everything is ill-conditioned
      const auto roots = polynomial_roots(c);
      const std::size_t n = step.size;
      const std::vector<Coefficient> one(step.columns.begin(), step.columns.end());
      std::vector<Coefficient> power(one), sizes(one.size());
      for (std::size_t k = 0; k < one.size(); ++k) sizes[k] = std::abs(one[k]);
      std::vector<Coefficient> absolute(sizes), magnitude(sizes);
      for (int exponent = 1; exponent <= int(roots.size()) + 1; ++exponent) {
        Coefficient trace = 0, terms = 0, expected = 0;
        for (std::size_t k = 0; k < n; ++k) trace += power[k * n + k], terms += magnitude[k * n + k];
        for (const auto& w : roots) expected += 2 * std::pow(w, exponent).real();
        EXPECT_NEAR(double(trace), double(expected),
                    100 * exponent * double(std::numeric_limits<T>::epsilon()) * (1 + double(terms)))
            << m.id << " at " << double(z.real()) << " + " << double(z.imag()) << " i, power " << exponent;
        std::vector<Coefficient> next(n * n, 0), next_size(n * n, 0);
        for (std::size_t col = 0; col < n; ++col)
          for (std::size_t k = 0; k < n; ++k)
            for (std::size_t r = 0; r < n; ++r) {
              next[col * n + r] += one[k * n + r] * power[col * n + k];
              next_size[col * n + r] += absolute[k * n + r] * magnitude[col * n + k];
            }
        power = next, magnitude = next_size;
      }
    }
  }
}

TEST(StabilityIdentity, OneStepOfEveryMultistepMethodHasTheRootsOfItsPolynomial) {
  int compared = 0;
  for (const auto& m : suite_methods()) {
    if (!detail::is_multistep(m.theory())) continue;
    expect_multistep_identity<double>(m), expect_multistep_identity<float>(m);
    ++compared;
  }
  EXPECT_GE(compared, 20);
}

/// The parasitic root of leapfrog grows from nothing but rounding: slowly, and on every damped problem.
TEST(StabilityGrowth, LeapfrogOnADecayGrowsByItsSecondRoot) {
  const auto decay = problem("dahlquist", "lambda_re=-1,lambda_im=0");
  for (const double h : {0.05, 0.2, 0.7}) {
    const StepProbe probe(method("leapfrog"), decay.homogeneous->system<double>());
    EXPECT_NEAR(double(probe(h).growth), std::asinh(h), 1e-12) << h;
    EXPECT_NEAR(growth_by_stepping<leapfrog>(decay, h), std::asinh(h), 1e-6) << h;
  }
}

// --- regions ---

double area(const std::vector<std::complex<double>>& polygon) {
  double sum = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const auto a = polygon[i], b = polygon[(i + 1) % polygon.size()];
    sum += (a.real() * b.imag() - b.real() * a.imag()) / 2;
  }
  return sum;
}

TEST(StabilityRegions, PolygonsAreTheBoundary) {
  const Theory theory = rk4.theory();
  const auto region = stability_region("rk4", theory);
  ASSERT_EQ(region.boundaries.size(), 1u);
  double left = 0, up = 0;
  for (const auto& z : region.boundaries[0]) {
    EXPECT_NEAR(double(amplification(theory, WideComplex(z.real(), z.imag()))), 1, 1e-9);
    left = std::min(left, z.real()), up = std::max(up, z.imag());
  }
  EXPECT_NEAR(left, -2.785, 0.01);
  EXPECT_NEAR(up, 2.95, 0.05);
  EXPECT_NEAR(area(stability_region("euler", explicit_euler.theory()).boundaries.at(0)), std::numbers::pi,
              2e-3);
  // implicit Euler: stable in the window but for the disc of radius 1 about 1, a hole that turns the other
  // way
  const auto outside =
      stability_region("implicit_euler", implicit_euler.theory(), RegionWindow{-3, 3, -3, 3});
  ASSERT_EQ(outside.boundaries.size(), 2u);
  EXPECT_NEAR(area(outside.boundaries[0]) + area(outside.boundaries[1]), 36 - std::numbers::pi, 2e-3);
}

TEST(StabilityRegions, MultistepBoundariesLieOnTheLocus) {
  const auto region = stability_region("adams_bashforth2", adams_bashforth2.theory());
  ASSERT_EQ(region.boundaries.size(), 1u);
  ASSERT_EQ(region.root_locus.size(), 1u);
  for (const auto& z : region.boundaries[0]) {
    double nearest = 1;
    for (const auto& l : region.root_locus[0]) nearest = std::min(nearest, std::abs(z - l));
    EXPECT_LT(nearest, 0.02);
  }
  EXPECT_FALSE(stability_region("stormer_verlet", stormer_verlet.theory()).reason.empty());
}

TEST(StabilityRegions, APredictorCorrectorHasTwoBranches) {
  const auto region = stability_region("adams_bashforth_moulton34", adams_bashforth_moulton34.theory());
  ASSERT_GE(region.boundaries.size(), 1u);
  for (const auto& z : region.boundaries[0]) {
    double nearest = 1;
    for (const auto& curve : region.root_locus)
      for (const auto& l : curve) nearest = std::min(nearest, std::abs(z - l));
    EXPECT_LT(nearest, 0.05);
  }
}

}  // namespace
}  // namespace odemark::stability_growth_test
