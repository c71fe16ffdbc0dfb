// The three kinds of theory behind linear_stability.hpp: stability functions, second-order steps, multistep.
#pragma once

#include "integrators/linear_stability.hpp"

namespace odemark::detail {

/// |Q|^2 - |P|^2 at z = r direction, |direction| = 1, as a polynomial in r with what must vanish set to 0.
RealPolynomial boundary_polynomial(const Theory& theory, WideComplex direction);
NonNegative stable_along_ray(const Theory& theory, WideComplex direction);
Coefficient log_amplification(const Theory& theory, WideComplex z);

/// sum_k p_k z^k.
WideComplex value_at(const std::vector<Coefficient>& p, WideComplex z);

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

/// Theories that act on (x, v) of one degree of freedom: moves, matrices that know no damping, functions.
bool is_second_order(const Theory& theory);
/// The matrix of a step whose entries are polynomials in dt, column-major.
std::vector<Coefficient> polynomial_matrix(const Theory& theory, Coefficient stiffness, Coefficient damping,
                                           Coefficient dt);
/// ln of the spectral radius, column-major.
Coefficient matrix_log_radius(const std::vector<Coefficient>& matrix);
/// Where a step that is a function and no polynomial is stable, in units of dt * rate.
NonNegative function_stable(const SecondOrderStep& step, Coefficient stiffness, Coefficient damping);

/// A linear form in (x_n, v_n), over a common denominator.
struct Form {
  RealPolynomial of_x, of_v;
};
/// One step as polynomials in dt, of moves or of a matrix that knows no damping.
struct StepMatrix {
  Form x, v;  // what becomes of (x_n, v_n), times the denominator
  RealPolynomial denominator;
  RealPolynomial trace;        // times the denominator
  RealPolynomial determinant;  // times its square
};
StepMatrix step_matrix(const Theory& theory, Coefficient stiffness, Coefficient damping);

/// In units of dt * rate.
NonNegative second_order_stable(const Theory& theory, Coefficient stiffness, Coefficient damping);
Coefficient second_order_log_radius(const Theory& theory, Coefficient stiffness, Coefficient damping,
                                    Coefficient dt);

}  // namespace odemark::detail
