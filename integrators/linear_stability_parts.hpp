// The three kinds of theory behind linear_stability.hpp: stability functions, second-order steps, multistep.
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

/// Theories that act on (x, v) of one degree of freedom: moves, matrices that know no damping, functions.
bool is_second_order(const Theory& theory);
/// The matrix of a step whose entries are polynomials in dt, column-major.
std::vector<Coefficient> polynomial_matrix(const Theory& theory, Coefficient stiffness, Coefficient damping,
                                           Coefficient dt);
/// ln of the spectral radius, column-major.
Coefficient matrix_log_radius(const std::vector<Coefficient>& matrix);
/// Where a step that is a function and no polynomial is stable, in units of dt * rate.
NonNegative function_stable(const SecondOrderStep& step, Coefficient stiffness, Coefficient damping);

/// In units of dt * rate.
NonNegative second_order_stable(const Theory& theory, Coefficient stiffness, Coefficient damping);
Coefficient second_order_log_radius(const Theory& theory, Coefficient stiffness, Coefficient damping,
                                    Coefficient dt);

}  // namespace odemark::detail
