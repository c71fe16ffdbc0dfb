// The three kinds of theory behind linear_stability.hpp: stability functions, moves, multistep.
#pragma once

#include "integrators/linear_stability.hpp"

namespace odemark::detail {

/// |Q|^2 - |P|^2 at z = r direction, |direction| = 1, as a polynomial in r with what must vanish set to 0.
RealPolynomial boundary_polynomial(const Theory& theory, WideComplex direction);
NonNegative stable_along_ray(const Theory& theory, WideComplex direction);
Coefficient log_amplification(const Theory& theory, WideComplex z);

NonNegative multistep_stable_along_ray(const Theory& theory, WideComplex direction);
bool zero_stable(const Theory& theory);
Coefficient largest_multistep_root(const Theory& theory, WideComplex z);

/// The 2x2 matrix of one step over its common denominator, as polynomials in dt: M = .../denominator.
struct StepMatrix {
  RealPolynomial trace, determinant,  // of the matrix times the denominator
      denominator;
};
StepMatrix step_matrix(const std::vector<SecondOrderMove>& moves, Coefficient stiffness, Coefficient damping);

/// In units of dt * rate.
NonNegative moves_stable(const std::vector<SecondOrderMove>& moves, Coefficient stiffness,
                         Coefficient damping);
Coefficient moves_log_radius(const std::vector<SecondOrderMove>& moves, Coefficient stiffness,
                             Coefficient damping, Coefficient dt);

}  // namespace odemark::detail
