// The facts of a method measured from its compiled step, beside what its coefficients say.
#pragma once

#include "bench/data/facts.hpp"
#include "integrators/any_method.hpp"

namespace odemark {

/// R(z) on a disk (moves: the 2x2 matrix; multistep: the characteristic polynomial), the same for the error
/// estimate, evaluations by counting, quadrature in t (nodes), the Jacobian of a step of symplectic methods,
/// the way back of symmetric ones, boundaries by growth; in double and in float.
std::vector<MeasuredFact> measure_facts(const AnyMethod& method);

/// One sentence for every fact that does not agree.
std::vector<std::string> measured_faults(const FactSheet& sheet);

namespace detail {

std::vector<MeasuredFact> measure_linear(const AnyMethod& method, const std::string& scalar);
std::vector<MeasuredFact> measure_nonlinear(const AnyMethod& method, const std::string& scalar);

}  // namespace detail

}  // namespace odemark
