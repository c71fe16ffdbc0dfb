// x = base + diagonal f(t, x) to the last digit: the equation of every one-stage implicit step.
#pragma once

#include "integrators/jacobian.hpp"
#include "integrators/shifted_lu.hpp"
#include "integrators/stepper.hpp"

namespace odemark {

/// Simplified Newton with the Jacobian at the known point (t0, y); where that fails, Newton proper.
template <System P>
class ImplicitEquation {
 public:
  using State = typename P::State;
  using Real = RealOf<State>;

  ImplicitEquation(const P& system, const State& model)
      : system_(system),
        slope_(model),
        correction_(model),
        spare_(model),
        moved_(model),
        jacobian_(jacobian_shape(system, model)),
        lu_(jacobian_.shape()) {}

  NewtonCounts counts() const { return counts_; }

  /// Starts from y; false where no solution was found.
  bool solve(Real t0, const State& y, Real t, const State& base, Real diagonal, State& x) {
    x = y;
    refresh(t0, y, diagonal);
    if (iterate(t, base, diagonal, x, false)) return true;
    x = y;
    return iterate(t, base, diagonal, x, true);
  }

 private:
  static constexpr int most_iterations = 12;

  void refresh(Real t, const State& at, Real diagonal) {
    evaluate_jacobian(system_, t, at, jacobian_, spare_, correction_, moved_);
    lu_.factorize_step(jacobian_, diagonal);
    ++counts_.lu;
  }

  bool iterate(Real t, const State& base, Real diagonal, State& x, bool every) {
    const Real tolerance = 4 * std::numeric_limits<Real>::epsilon();
    Real previous = std::numeric_limits<Real>::infinity();
    for (int iteration = 0; iteration < most_iterations * (every ? 4 : 1); ++iteration) {
      if (every) refresh(t, x, diagonal);
      system_.rhs(t, x, slope_);
      for_each_component(x, [&](std::size_t i) {
        correction_.data()[i] = base.data()[i] + diagonal * slope_.data()[i] - x.data()[i];
      });
      lu_.solve_in_place(correction_.data());
      ++counts_.newton;
      Real moved = 0, scale = std::numeric_limits<Real>::min();  // sums, because std::max would swallow a NaN
      Real terms = 0;  // what x is the small difference of, where the step is long
      for_each_component(x, [&](std::size_t i) {
        x.data()[i] += correction_.data()[i];
        moved += std::abs(correction_.data()[i]);
        scale += std::abs(x.data()[i]);
        terms += std::abs(base.data()[i]) + std::abs(diagonal * slope_.data()[i]);
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
  State slope_, correction_, spare_, moved_;
  JacobianMatrix<Real> jacobian_;
  ShiftedLu<Real> lu_;
  NewtonCounts counts_;
};

}  // namespace odemark
