// Keeps a value from being optimised away, without the compiler losing it.
#pragma once

#include <cstddef>

namespace odemark {

/// Google Benchmark 1.7.1's DoNotOptimize(double&) destroys the value under GCC 12 (constraint "+m,r"); this
/// one asks for memory only.
template <class T>
inline void keep(T& value) {
  asm volatile("" : "+m"(value) : : "memory");
}

}  // namespace odemark
