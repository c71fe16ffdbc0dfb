// The average vector field method: implicit, keeps the energy of every y' = S grad H with constant skew S.
#pragma once

#include "integrators/compensated.hpp"
#include "integrators/jacobian.hpp"
#include "integrators/shifted_lu.hpp"
#include "integrators/theory.hpp"

namespace odemark {

template <const auto& method, System P>
class AverageVectorFieldStepper;

/// y+ = y + h int_0^1 f(t + s h, y + s (y+ - y)) ds. Then (H(y+) - H(y)) / h = g' S g = 0, where g is the
/// integral of grad H along the chord: a discrete gradient that needs no H. The integral is a Gauss
/// quadrature on [0, 1]; energy is exact for polynomial H of degree 2 Points, else as exact as the
/// quadrature.
template <std::size_t Points>
struct AverageVectorField {
  static constexpr std::string_view kind_name = "average vector field";
  static constexpr unsigned needs = 0;
  static constexpr bool solves_equations = true;
  static constexpr std::size_t points = Points;

  std::string_view id, source;
  int order;
  int embedded_order = 0;
  std::array<Coefficient, Points> nodes{}, weights{};
  std::string_view note = "", advice = "";

  /// Degree of polynomials H along the chord for which energy is exact: one more than that of the quadrature.
  constexpr int energy_degree() const {
    for (int degree = 0;; ++degree) {
      Coefficient sum = -1.0L / Coefficient(degree + 1);
      for (std::size_t k = 0; k < Points; ++k) {
        Coefficient power = weights[k];
        for (int i = 0; i < degree; ++i) power *= nodes[k];
        sum += power;
      }
      if (!(sum <= 2e-18L && sum >= -2e-18L)) return degree;
    }
  }
  /// On y' = lambda y the integral is the mean of both ends, so this is the trapezoid.
  Theory theory() const {
    Theory theory;
    theory.numerator = {1, 0.5L}, theory.denominator = {1, -0.5L};
    return theory;
  }

  template <const auto& method, System P>
  using Stepper = AverageVectorFieldStepper<method, P>;
};

template <const auto& method, System P>
class AverageVectorFieldStepper {
 public:
  using State = typename P::State;
  using Real = RealOf<State>;

  AverageVectorFieldStepper(const P& system, const State& model)
      : system_(system),
        gain_(model),
        point_(model),
        slope_(model),
        mean_(model),
        moved_(model),
        jacobian_(jacobian_shape(system, model)),
        one_jacobian_(jacobian_),
        lu_(jacobian_.shape()) {}

  void start() {}
  void accept() {}
  NewtonCounts newton_counts() const { return counts_; }

  StepStatus attempt(Real t, const State& y, Real h, State& next, State&) {
    if (!find_gain(t, y, h)) return StepStatus::newton_diverged;
    for_each_component(y, [&](std::size_t i) { next.data()[i] = y.data()[i] + gain_.data()[i]; });
    return StepStatus::ok;
  }

  StepStatus attempt_compensated(Real t, const State& y, const State& carry, Real h, State& next,
                                 State& next_carry) {
    if (!find_gain(t, y, h)) return StepStatus::newton_diverged;
    add_compensated(y, carry, gain_, next, next_carry);
    return StepStatus::ok;
  }

 private:
  static constexpr int most_iterations = 12;

  bool find_gain(Real t, const State& y, Real h) {
    evaluate_jacobian(system_, t, y, jacobian_, point_, mean_, moved_);
    factorize(h);
    // the Jacobian of the start may be far from the mean along the chord: once more, with Newton proper
    return iterate(t, y, h, false) || iterate(t, y, h, true);
  }

  void factorize(Real h) {
    lu_.factorize_step(jacobian_, h / 2);
    ++counts_.lu;
  }

  void place(const State& y, std::size_t k) {
    const Real s = static_cast<Real>(method.nodes[k]);
    for_each_component(y, [&](std::size_t i) { point_.data()[i] = y.data()[i] + s * gain_.data()[i]; });
  }

  /// The derivative of the mean slope with respect to the gain is half of the mean of 2 s J.
  void average_jacobian(Real t, const State& y, Real h) {
    jacobian_.clear();
    for (std::size_t k = 0; k < method.points; ++k) {
      const Real s = static_cast<Real>(method.nodes[k]), w = static_cast<Real>(method.weights[k]);
      place(y, k);
      evaluate_jacobian(system_, t + s * h, point_, one_jacobian_, slope_, mean_, moved_);
      jacobian_.add(2 * w * s, one_jacobian_);
    }
  }

  /// Newton for gain = h mean slope; `every` takes the Jacobian along the present chord in every iteration.
  bool iterate(Real t, const State& y, Real h, bool every) {
    const Real tolerance = std::numeric_limits<Real>::epsilon();
    Real previous = std::numeric_limits<Real>::infinity();
    for_each_component(y, [&](std::size_t i) { gain_.data()[i] = 0; });
    for (int iteration = 0; iteration < most_iterations * (every ? 4 : 1); ++iteration) {
      if (every) {
        average_jacobian(t, y, h);
        factorize(h);
      }
      Real slopes = 0;
      for_each_component(y, [&](std::size_t i) { mean_.data()[i] = 0; });
      for (std::size_t k = 0; k < method.points; ++k) {
        const Real s = static_cast<Real>(method.nodes[k]), w = static_cast<Real>(method.weights[k]);
        place(y, k);
        system_.rhs(t + s * h, point_, slope_);
        for_each_component(y, [&](std::size_t i) {
          mean_.data()[i] += w * slope_.data()[i];
          slopes += w * std::abs(slope_.data()[i]);
        });
      }
      for_each_component(y, [&](std::size_t i) { moved_.data()[i] = h * mean_.data()[i] - gain_.data()[i]; });
      lu_.solve_in_place(moved_.data());
      ++counts_.newton;
      // sums, because std::max would swallow a NaN; `terms` is what the gain is the small difference of
      Real moved = 0, scale = std::numeric_limits<Real>::min(), terms = std::abs(h) * slopes;
      for_each_component(y, [&](std::size_t i) {
        gain_.data()[i] += moved_.data()[i];
        moved += std::abs(moved_.data()[i]);
        scale += std::abs(y.data()[i] + gain_.data()[i]);
        terms += std::abs(y.data()[i]);
      });
      if (!std::isfinite(moved + scale)) return false;
      // done, or as far as rounding lets it come: corrections that no longer shrink and are small already
      const bool stalled = moved >= previous / 2 && moved <= 1024 * tolerance * (scale + terms);
      if (moved <= tolerance * scale || stalled) return true;
      if (!every && iteration > 2 && moved > 2 * previous) return false;
      previous = moved;
    }
    return false;
  }

  const P& system_;
  State gain_, point_, slope_, mean_, moved_;  // gain_ is y+ - y
  JacobianMatrix<Real> jacobian_, one_jacobian_;
  ShiftedLu<Real> lu_;
  NewtonCounts counts_;
};

}  // namespace odemark
