// The orthogonal polynomials of ROCK2 and ROCK4, computed from the zeros of their weights.
#pragma once

#include "integrators/stabilised_recurrence.hpp"

namespace odemark {

/// R(z) = w(z) P(z), w of degree p = 2 or 4 without real zeros, P of degree stages - p from the family that
/// is orthogonal with respect to w^2 / sqrt(1 - x^2), x = origin + z / scale: A. Abdulle, A. A. Medovikov,
/// Numer. Math. 90 (2001) 1-18; A. Abdulle, SIAM J. Sci. Comput. 23 (2002) 2041-2054. Computed, not copied
/// from the tables of the published codes: with the zeros of w (rock_polynomials.cpp) the recurrence follows
/// in long double.
struct RockPolynomial {
  std::size_t stages = 0;
  Coefficient real_interval = 0;
  std::vector<RecurrenceStage> recurrence;
  std::array<Coefficient, 5> last{};  // w(z), ascending
  LastStages finish;                  // of ROCK4
};

/// Ascending in the number of stages. Computed at the first call (some milliseconds), so a stepper asks for
/// it when it is made.
const std::vector<RockPolynomial>& rock_polynomials(StabilisedFamily family);
/// The one with this many stages; the largest where there is none.
const RockPolynomial& rock_polynomial(StabilisedFamily family, std::size_t stages);

/// The last stages of ROCK4: order 4 together with a recurrence whose elementary weights up to order 4 are
/// `before`, in the order of elementary_weights.
LastStages last_stages_of_order_four(const std::array<Coefficient, 8>& before);
/// Elementary weights of Y_count for the trees 1, [1], [1,1], [[1]], [1,1,1], [1,[1]], [[1,1]], [[[1]]].
std::array<Coefficient, 8> elementary_weights(const std::vector<RecurrenceStage>& recurrence);

}  // namespace odemark
