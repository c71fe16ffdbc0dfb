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

/// Theories that act on (x, v) of one degree of freedom: moves, and matrices that know no damping.
bool is_second_order(const Theory& theory);
/// In units of dt * rate.
NonNegative second_order_stable(const Theory& theory, Coefficient stiffness, Coefficient damping);
Coefficient second_order_log_radius(const Theory& theory, Coefficient stiffness, Coefficient damping,
                                    Coefficient dt);

}  // namespace odemark::detail
