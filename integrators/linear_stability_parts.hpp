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

/// In units of dt * rate.
NonNegative moves_stable(const std::vector<SecondOrderMove>& moves, Coefficient stiffness,
                         Coefficient damping);
Coefficient moves_log_radius(const std::vector<SecondOrderMove>& moves, Coefficient stiffness,
                             Coefficient damping, Coefficient dt);

/// The same for Nystrom methods, where there is no damping.
NonNegative oscillator_stable(const OscillatorMatrix& step, Coefficient stiffness);
Coefficient oscillator_log_radius(const OscillatorMatrix& step, Coefficient stiffness, Coefficient dt);

}  // namespace odemark::detail
