// Adding an increment to a state without losing what the state cannot hold.
#pragma once

#include "integrators/stepper.hpp"

namespace odemark {

/// next + next_carry = y + (carry + increment), where next_carry is below half an ulp of next (D. E. Knuth,
/// The Art of Computer Programming 2, 4.2.2, theorem B: holds whichever of the two is larger).
template <State S>
void add_compensated(const S& y, const S& carry, const S& increment, S& next, S& next_carry) {
  for_each_component(y, [&](std::size_t i) {
    const auto addend = increment.data()[i] + carry.data()[i];
    const auto sum = y.data()[i] + addend;
    const auto rounded = sum - y.data()[i];
    next_carry.data()[i] = (y.data()[i] - (sum - rounded)) + (addend - rounded);
    next.data()[i] = sum;
  });
}

}  // namespace odemark
