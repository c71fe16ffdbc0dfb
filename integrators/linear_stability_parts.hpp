// The three kinds of theory behind linear_stability.hpp: stability functions, moves, multistep.
#pragma once

#include "integrators/linear_stability.hpp"

namespace odemark::detail {

/// |Q|^2 - |P|^2 at z = r direction, |direction| = 1, as a polynomial in r with what must vanish set to 0.
RealPolynomial boundary_polynomial(const Theory& theory, WideComplex direction);
NonNegative stable_along_ray(const Theory& theory, WideComplex direction);
Coefficient log_amplification(const Theory& theory, WideComplex z);

bool is_multistep(const Theory& theory);
/// The coefficient of z^k w^j is [k][j]: of rho(w) - z sigma(w), or of what a predictor-corrector adds in
/// z^2.
std::vector<std::vector<Coefficient>> characteristic_of(const Theory& theory);
/// sum_j c_j w^j at one z.
std::vector<WideComplex> characteristic_at(const Theory& theory, WideComplex z);
NonNegative multistep_stable_along_ray(const Theory& theory, WideComplex direction);
bool zero_stable(const Theory& theory);
Coefficient largest_multistep_root(const Theory& theory, WideComplex z);
/// ln of that root. Near z = 0 the root that follows e^z is found as e^z (1 + what its order leaves), so that
/// growth far below a rounding of 1 keeps its sign: otherwise Adams methods seem stable where they are not.
Coefficient multistep_log_amplification(const Theory& theory, WideComplex z);

/// In units of dt * rate.
NonNegative moves_stable(const std::vector<SecondOrderMove>& moves, Coefficient stiffness,
                         Coefficient damping);
Coefficient moves_log_radius(const std::vector<SecondOrderMove>& moves, Coefficient stiffness,
                             Coefficient damping, Coefficient dt);

}  // namespace odemark::detail
