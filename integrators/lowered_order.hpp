// What theory takes back of a claimed order on some kinds of problems.
#pragma once

#include "integrators/theory.hpp"

namespace odemark {

/// The order of a second-order step where the force depends on velocity: that of the step's trace and
/// determinant on x'' = -x - v / 2, at most `claimed`. A kick that sees the velocity of the moment is no
/// exact flow there, and most splittings are left with order 1. `claimed` where theory knows no such step.
int order_with_damping(const Theory& theory, int claimed);

/// A multistep method with a second root of rho on the unit circle (leapfrog, Milne): to z = h lambda it
/// answers like e^(-z), so that where the flow contracts it makes rounding and start grow.
bool is_weakly_stable(const Theory& theory);

}  // namespace odemark
