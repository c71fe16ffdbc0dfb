// Functions made of pieces, written with abs so that every number type can carry them and a truth finds their
// kinks.
#pragma once
#include <cmath>

namespace odemark {

/// max(x, 0), to the bit.
template <class T>
T positive_part(const T& x) {
  using std::abs;
  return (x + abs(x)) / 2;
}

/// 0 below 0, x up to `top`, `top` above.
template <class T>
T clamped(const T& x, const T& top) {
  return positive_part(x) - positive_part(T(x - top));
}

}  // namespace odemark
