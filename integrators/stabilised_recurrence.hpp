// The three-term recurrences of stabilised explicit methods for any number of stages, compiled once.
#pragma once

#include <array>
#include <complex>
#include <vector>

#include "integrators/stepper.hpp"

namespace odemark {

enum class StabilisedFamily { rkc1, rkc2, rkl2, rock2, rock4 };

/// Y_0 = y, and for j = 1 ... count, with F_j = f(t + node_j h, Y_j):
///   Y_j = Y_0 + mu (Y_(j-1) - Y_0) + nu (Y_(j-2) - Y_0) + h (slope F_(j-1) + first_slope F_0).
/// Rounding errors grow with the square of the number of stages in this form, not exponentially as in
/// Butcher's (P. J. van der Houwen, B. P. Sommeijer, ZAMM 60 (1980) 479-485).
struct RecurrenceStage {
  Coefficient mu = 0, nu = 0, slope = 0, first_slope = 0;
  Coefficient node = 0;  // where Y_j stands
};

/// The four explicit Runge-Kutta stages that end a step of ROCK4, from Y_count on; `node` and the weights are
/// in units of h, `error` are the weights of the difference to order 3, the last one of the slope at the end.
struct LastStages {
  std::array<std::array<Coefficient, 4>, 4> a{};
  std::array<Coefficient, 4> b{}, node{};
  std::array<Coefficient, 5> error{};
};

struct StabilisedRecurrence {
  std::vector<RecurrenceStage> stages;  // index 0 is y itself
  std::size_t count = 0;
  /// What stages of their own at the end do on y' = lambda y, ascending: 1 + 2 sigma z + tau z^2 in ROCK2, of
  /// degree 4 in ROCK4, 1 elsewhere.
  std::array<Coefficient, 5> last{1};
  LastStages finish;
};

/// How much larger than the unit roundoff the rounding errors of one step may become: the square of the
/// number of stages in the recurrences of RKC and RKL2; in ROCK the last stages multiply what the recurrence
/// leaves by |w(-interval)|.
Coefficient internal_amplification(StabilisedFamily family, std::size_t stages);

/// Largest number of stages that a step may take; with a unit roundoff u, at most as many as keep
/// internal_amplification u below 10 sqrt(u).
std::size_t stage_cap(StabilisedFamily family, Coefficient roundoff = 0);

/// The fewest stages that the family has whose real interval is at least `reach` = h times the spectral
/// radius, or the cap where none suffices. NaN gets the cap.
std::size_t stages_for(StabilisedFamily family, Coefficient reach, std::size_t cap);

/// R is stable (and damped, but for RKL2) on [-real_interval, 0].
Coefficient real_interval(StabilisedFamily family, std::size_t stages);

/// Room for the largest step, so that fill_recurrence never allocates.
StabilisedRecurrence room_for(StabilisedFamily family);
void fill_recurrence(StabilisedFamily family, std::size_t stages, StabilisedRecurrence& out);

/// R(z), by the recurrence itself: accurate for any number of stages.
std::complex<Coefficient> stability_value(StabilisedFamily family, std::size_t stages,
                                          std::complex<Coefficient> z);
/// R as coefficients of z^k. They alternate and cancel: of use to about 30 stages.
std::vector<Coefficient> stability_polynomial(StabilisedFamily family, std::size_t stages);

}  // namespace odemark
