// The orthogonal polynomials of ROCK2, computed from the zeros of their weight.
#pragma once

#include "integrators/stabilised_recurrence.hpp"

namespace odemark {

/// R(z) = w(z) P(z), w of degree 2 without real zeros, P of degree stages - 2 from the family that is
/// orthogonal with respect to w^2 / sqrt(1 - x^2), x = origin + z / scale: A. Abdulle, A. A. Medovikov,
/// Numer. Math. 90 (2001) 1-18. Computed, not copied from the tables of the published code: with the zeros of
/// w (rock2_polynomials.cpp) the recurrence follows in long double.
struct Rock2Polynomial {
  std::size_t stages = 0;
  Coefficient real_interval = 0;
  Coefficient sigma = 0, tau = 0;  // w = 1 + 2 sigma z + tau z^2
  std::vector<RecurrenceStage> recurrence;
};

/// Ascending in the number of stages. Computed at the first call (a few milliseconds), so a stepper asks for
/// it when it is made.
const std::vector<Rock2Polynomial>& rock2_polynomials();
/// The one with this many stages; the largest where there is none.
const Rock2Polynomial& rock2_polynomial(std::size_t stages);

}  // namespace odemark
