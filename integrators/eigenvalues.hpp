// Eigenvalues of small matrices and roots of small polynomials, in the widest arithmetic there is.
#pragma once

#include <complex>
#include <vector>

#include "integrators/stepper.hpp"

namespace odemark {

using WideComplex = std::complex<Coefficient>;

/// Of a real matrix, column-major. Exactly imaginary where a 2x2 matrix has trace 0; for larger matrices real
/// parts that are rounding noise are set to 0.
std::vector<WideComplex> eigenvalues(std::size_t size, const std::vector<Coefficient>& column_major);

/// All roots of c[0] + c[1] w + ...; leading zeros are dropped.
std::vector<WideComplex> polynomial_roots(std::vector<WideComplex> c);

}  // namespace odemark
