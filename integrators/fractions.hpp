// The simplest fraction behind a coefficient that was written as one.
#pragma once

#include <cstdint>
#include <optional>

#include "integrators/stepper.hpp"

namespace odemark {

struct Fraction {
  std::int64_t numerator = 0, denominator = 1;
};

/// The fraction of smallest denominator that rounds to x, by continued fractions. Only where numerator and
/// denominator are below 2^31: the 64 bits of a long double name one such fraction at most, but for the
/// largest of them it may be by accident. Whoever concludes from it has to check what he concludes.
std::optional<Fraction> simplest_fraction(Coefficient x);

}  // namespace odemark
