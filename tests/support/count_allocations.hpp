// Counts what the program takes from the heap. Include it in one file of a program only: it replaces malloc.
#pragma once

#include <atomic>
#include <cstdlib>
#include <new>

namespace odemark {
inline std::atomic<long> heap_requests{0};
inline std::atomic<std::size_t> largest_request{0};  // bytes; a test may set it back

inline void count_request(std::size_t bytes) {
  heap_requests.fetch_add(1, std::memory_order_relaxed);
  std::size_t largest = largest_request.load(std::memory_order_relaxed);
  while (largest < bytes && !largest_request.compare_exchange_weak(largest, bytes)) {
  }
}
}  // namespace odemark

#if defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(memory_sanitizer) || __has_feature(thread_sanitizer)
#define ODEMARK_SANITIZED
#endif
#endif
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define ODEMARK_SANITIZED
#endif

#if defined(__GLIBC__) && !defined(ODEMARK_SANITIZED)
// Everything goes through malloc in the end: operator new, Eigen, C libraries.
extern "C" {
void* __libc_malloc(std::size_t size);
void* malloc(std::size_t size) noexcept {
  odemark::count_request(size);
  return __libc_malloc(size);
}
}
#else
// A sanitizer owns malloc; what C++ code asks for is still seen.
void* operator new(std::size_t size) {
  odemark::count_request(size);
  if (void* p = std::malloc(size == 0 ? 1 : size)) return p;
  throw std::bad_alloc();
}
void operator delete(void* p) noexcept { std::free(p); }
void operator delete(void* p, std::size_t) noexcept { std::free(p); }
#endif
